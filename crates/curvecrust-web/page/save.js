// A result as a file.

const TYPES = {
  svg: "image/svg+xml",
  geojson: "application/geo+json",
  csv: "text/csv",
  png: "image/png",
};

/** The curves of an answer, each with its points in order. */
function curvesOf(points, answer) {
  const curves = [];
  let at = 0;
  answer.lengths.forEach((length, i) => {
    const indices = Array.from(answer.vertices.subarray(at, at + length));
    at += length;
    const closed = answer.closed[i] === 1;
    curves.push({ indices, closed, places: indices.map((v) => [points[2 * v], points[2 * v + 1]]) });
  });
  return curves;
}

function svg(points, answer, [x0, y0, x1, y1], up) {
  const size = Math.max(x1 - x0, y1 - y0) || 1;
  const turn = (y) => (up ? y0 + y1 - y : y);
  const paths = curvesOf(points, answer).map(({ places, closed }) => {
    const d = places.map(([x, y]) => `${x} ${turn(y)}`).join(" L ");
    return `  <path d="M ${d}${closed ? " Z" : ""}"/>`;
  });
  const margin = 0.05 * size;
  const box = [x0 - margin, y0 - margin, x1 - x0 + 2 * margin, y1 - y0 + 2 * margin].join(" ");
  const style = `fill="none" stroke="black" stroke-width="${size / 300}"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}">\n <g ${style}>\n${paths.join("\n")}\n </g>\n</svg>\n`;
}

function geojson(points, answer) {
  const features = curvesOf(points, answer).map(({ places, closed }) => ({
    type: "Feature",
    properties: { closed },
    geometry: closed
      ? { type: "Polygon", coordinates: [[...places, places[0]]] }
      : { type: "LineString", coordinates: places },
  }));
  return JSON.stringify({ type: "FeatureCollection", features });
}

function csv(points, answer) {
  const rows = curvesOf(points, answer).flatMap(({ places, indices, closed }, curve) =>
    places.map(([x, y], i) => `${curve},${closed},${indices[i]},${x},${y}`),
  );
  return ["curve,closed,index,x,y", ...rows, ""].join("\n");
}

/** Hands a result to the reader as a file. */
export async function save(kind, { points, answer, plot }) {
  const content = {
    svg: () => svg(points, answer, plot.box, plot.up),
    geojson: () => geojson(points, answer),
    csv: () => csv(points, answer),
    png: () => new Promise((resolve) => plot.canvas.toBlob(resolve, TYPES.png)),
  };
  const blob = new Blob([await content[kind]()], { type: TYPES[kind] });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = `curves.${kind}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
