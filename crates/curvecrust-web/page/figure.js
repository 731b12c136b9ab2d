// The figures of the guided page: a section with words, and points that can be dragged.

import { Plot, ring, stepped } from "./plot.js";

const plots = [];

/** Paints all figures anew, when they are shown. */
export function redrawFigures() {
  for (const plot of plots) plot.redraw();
}

/** A section with its words, a figure, and a slider if there is a range for one. */
export function section(title, words, range) {
  const part = document.createElement("section");
  const text = document.createElement("div");
  const heading = Object.assign(document.createElement("h2"), { textContent: title });
  text.append(heading, ...words.map((line) => Object.assign(document.createElement("p"), { textContent: line })));
  const note = Object.assign(document.createElement("p"), { className: "readout" });
  note.setAttribute("aria-live", "polite");
  let slider = null;
  if (range) {
    slider = Object.assign(document.createElement("input"), { type: "range", ...range });
    slider.setAttribute("aria-label", range.label);
    text.append(slider);
  }
  text.append(note);
  const figure = document.createElement("figure");
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", title);
  figure.append(canvas);
  part.append(text, figure);
  document.getElementById("learn").append(part);
  const plot = new Plot(canvas);
  plots.push(plot);
  return { plot, slider, note, text };
}

/** A circle of the plane. */
export function circle(g, plot, x, y, radius, colour) {
  g.strokeStyle = colour;
  g.lineWidth = 1.5;
  g.beginPath();
  g.arc(plot.x(x), plot.y(y), radius * plot.scale, 0, 2 * Math.PI);
  g.stroke();
}

/** What keys do in a figure whose points can be dragged. */
const KEYS = [
  "Keys in the figure: full stop and comma hold the next and the previous point,",
  "arrows move it, Shift by larger steps, Enter leaves it.",
].join(" ");

/**
 * Lets points be dragged, by a pointer or by keys. `places` gives them, `put` takes one to a place,
 * and `tell` is called when something has changed. Returns what paints and names the point that is
 * selected.
 */
export function draggable(plot, { places, put, tell }) {
  let [selected, held] = [-1, false];
  const select = (point, hold) => {
    [selected, held] = [point, hold];
    tell();
  };
  const step = (by) => select(stepped(selected, by, places().length / 2), true);
  const place = () => places().slice(2 * selected, 2 * selected + 2);
  const pick = (x, y, within) => {
    const found = plot.nearest(places(), x, y, within + 6);
    select(found, found >= 0);
  };
  plot.listen({
    down: pick,
    move: (x, y, pressed) => {
      if (!pressed || !held) return;
      put(selected, plot.at(x, y));
      tell();
    },
    holds: () => (held ? place() : null),
    leave: () => select(selected, false),
    key: (key) => {
      const by = { ".": 1, ",": -1 }[key];
      if (by) step(by);
      else if (key === "Escape") select(-1, false);
      return by !== undefined || key === "Escape";
    },
  });
  plot.canvas.tabIndex = 0;
  plot.canvas.setAttribute("role", "application");
  describe(plot.canvas);
  return {
    paint: (g, picture, colour) => selected >= 0 && ring(g, picture, colour, ...place()),
    words: (name) => (selected < 0 ? "" : `${name(selected)}, at ${place().map(fixed).join(", ")}.`),
  };
}

const fixed = (v) => v.toFixed(2);

/** Says beside a figure what its keys do. */
function describe(canvas) {
  const id = `figure-keys-${plots.length}`;
  const hint = Object.assign(document.createElement("p"), { id, className: "hint", textContent: KEYS });
  canvas.closest("section").firstElementChild.append(hint);
  canvas.setAttribute("aria-describedby", id);
}
