// The page in a real browser. Arguments: the folder of the page, a file with what the native
// library finds, a folder for pictures. The environment names the folder of playwright-core and
// the browser.

import assert from "node:assert/strict";
import { readFile, mkdir } from "node:fs/promises";
import { brotliCompressSync } from "node:zlib";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join } from "node:path";
import { bend, bending, keysOfDrawing, links, nodes, touch } from "./drawing.mjs";
import { figure8, figureOf3 } from "./figures.mjs";
import { drop, settle, text } from "./page.mjs";
import { dragging, keys } from "./points.mjs";

const [folder, expectedFile, pictures] = process.argv.slice(2);
const { chromium } = createRequire(join(process.env.PLAYWRIGHT, "x.js"))("playwright-core");
const expected = JSON.parse(await readFile(expectedFile, "utf8"));

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/** Shows the folder at some port. */
function serve() {
  const server = createServer(async (request, response) => {
    const name = request.url === "/" ? "index.html" : request.url.split(/[?#]/)[0].slice(1);
    try {
      const body = await readFile(join(folder, name));
      response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "text/plain" }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

const server = await serve();
const address = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.BROWSER,
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});

const problems = [];
let requests = [];

/** A page that notes every error and every request. */
async function open(options = {}, fragment = "") {
  const page = await browser.newPage(options);
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("request", (request) => request.url().startsWith("http") && requests.push(request.url()));
  const start = Date.now();
  await page.goto(address + fragment);
  await page.waitForFunction(() => /edge/.test(document.getElementById("caption-a").textContent));
  const milliseconds = Date.now() - start;
  await page.waitForSelector("html[data-ready]");
  return { page, milliseconds };
}

async function formats(page) {
  await page.click("#tab-reconstruct");
  const circle = (x, y) => `<circle cx="${x}" cy="${y}" r="1"/>`;
  const square = [[0, 0], [1, 1], [1, 0], [0, 1]];
  const geojson = JSON.stringify({ type: "MultiPoint", coordinates: square });
  const svg = `<svg xmlns="http://www.w3.org/2000/svg">${square.map((p) => circle(...p)).join("")}</svg>`;
  for (const [name, body] of [["a.csv", "x,y\n0,0\n1,1\n1,0\n0,1\n"], ["a.txt", "0 0\n1 1\n1 0\n0 1\n"], ["a.geojson", geojson], ["a.svg", svg]]) {
    await page.click("[data-change=clear]");
    await drop(page, name, body);
    assert.match(await text(page, "#caption-a"), /4 edges, 1 closed/, name);
    assert.ok(await page.locator("#message").isHidden(), name);
  }
  for (const [name, body] of [["b.csv", "hello"], ["b.svg", "<svg"], ["b.geojson", "{}"], ["b.png", "\u0089PNG\r\n\u0000"]]) {
    await drop(page, name, body);
    assert.ok(await page.locator("#message").isVisible(), name);
    assert.match(await text(page, "#caption-a"), /4 edges/, "the state is kept");
  }
}

async function clicks(page) {
  await page.click("#canvas-a", { position: { x: 30, y: 120 } });
  await settle(page);
  assert.match(await text(page, "#caption-a"), /5 edges|4 edges/);
  await page.focus("#canvas-a");
  await page.keyboard.press("n");
  assert.match(await text(page, "#reason"), /Edge .* by least-detour/);
  await page.click("[data-change=undo]");
  await settle(page);
}

async function saves(page) {
  for (const kind of ["svg", "geojson", "csv", "png"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[data-export=${kind}]`)]);
    const body = await readFile(await download.path());
    assert.ok(body.length > 50, kind);
    if (kind === "geojson") assert.equal(JSON.parse(body).features.length, 1);
  }
}

async function samples(page) {
  await page.click("#tab-sample");
  await settle(page);
  const before = await text(page, "#sample-caption");
  await page.locator("#rho").fill("0.5");
  await settle(page);
  const after = await text(page, "#sample-caption");
  assert.ok(parseInt(after, 10) > parseInt(before, 10), `${before} / ${after}`);
  await page.locator("#rho").fill("0.95");
  assert.match(await text(page, "#guarantee"), /nothing is guaranteed/);
  await drop(page, "bad.svg", "<svg xmlns='http://www.w3.org/2000/svg'><path d='M 0 0 H'/></svg>");
  assert.ok(await page.locator("#message").isVisible());
  await page.locator("#rho").fill("0.9");
  await settle(page);
  assert.equal(parseInt(await text(page, "#sample-caption"), 10), parseInt(before, 10));
  // As icons are: a rectangle with corners, moved.
  const icon = "<svg xmlns='http://www.w3.org/2000/svg'><g transform='scale(3)'><rect width='9' height='5'/></g></svg>";
  await drop(page, "icon.svg", icon);
  assert.match(await text(page, "#sample-caption"), /least-detour returns it exactly, 4 corners/);
}

/** Edges and samples in the browser against those of the native library. */
async function agreement(page) {
  const found = await page.evaluate(async () => {
    const { Lane } = await import("./engine.js");
    const { curves, points } = await import("./fixtures.js");
    const { ALGORITHMS } = await import("./algorithms.js");
    const lane = new Lane();
    const result = { edges: {}, samples: {} };
    for (const { name, points: list } of points) {
      result.edges[name] = {};
      for (const algorithm of ALGORITHMS) {
        const answer = await lane.ask({ reconstruct: { algorithm } }, Float64Array.from(list));
        result.edges[name][algorithm] = Array.from(answer.edges);
      }
    }
    for (const { name, svg } of curves) {
      await lane.curve({ curve: { svg } });
      const answer = await lane.ask({ sample: { condition: "rho", bound: 0.9 } });
      result.samples[name] = Array.from(answer.samples);
    }
    return result;
  });
  assert.deepEqual(found.edges, expected.edges);
  assert.deepEqual(found.samples, expected.samples);
}

async function times(page) {
  return page.evaluate(async () => {
    const { Lane } = await import("./engine.js");
    const { curves } = await import("./fixtures.js");
    const lane = new Lane();
    await lane.curve({ curve: { svg: curves.find(({ name }) => name === "bunny").svg } });
    const drags = [];
    for (let rho = 0.5; rho < 0.9; rho += 0.02) {
      drags.push((await lane.ask({ sample: { condition: "rho", bound: rho } })).milliseconds);
    }
    const spiral = (count) =>
      Float64Array.from({ length: 2 * count }, (_, i) => {
        const angle = Math.sqrt((i >> 1) + 1) * 0.5;
        return angle * (i & 1 ? Math.sin(angle) : Math.cos(angle));
      });
    const many = spiral(100_000);
    let best = Infinity;
    for (let i = 0; i < 10; i++) {
      const answer = await lane.ask({ reconstruct: { algorithm: "hnn-crust" } }, many);
      best = Math.min(best, answer.milliseconds);
    }
    const million = await lane.ask({ reconstruct: { algorithm: "hnn-crust" } }, spiral(1_000_000));
    drags.sort((a, b) => a - b);
    return { drag: drags[drags.length >> 1], many: best, million: million.milliseconds };
  });
}

async function screenshots() {
  await mkdir(pictures, { recursive: true });
  for (const width of [360, 900, 1600]) {
    for (const colorScheme of ["light", "dark"]) {
      const options = { viewport: { width, height: 900 }, colorScheme, reducedMotion: "reduce" };
      const { page } = await open(options);
      const shoot = (name) => screenshot(page, `${name}-${width}-${colorScheme}.png`);
      for (const view of ["reconstruct", "sample", "learn"]) {
        await page.click(`#tab-${view}`);
        await shoot(view);
      }
      await page.click("#tab-sample");
      await bend(page);
      await shoot("drawing");
      await page.close();
    }
  }
}

/** The whole page as a picture, which must not be too wide. */
async function screenshot(page, file) {
  await page.waitForTimeout(700);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `${file}: ${overflow} too wide`);
  await page.screenshot({ path: join(pictures, file), fullPage: true });
}

const { page, milliseconds } = await open({ viewport: { width: 1200, height: 900 } });
await settle(page);
requests = [];
await formats(page);
await clicks(page);
await keys(page);
await dragging(page);
await saves(page);
await samples(page);
await nodes(page);
await bending(page);
await keysOfDrawing(page);
await agreement(page);
const took = await times(page);
await page.click("#tab-learn");
await settle(page);
await figureOf3(page);
await figure8(page);
await page.click("#tab-reconstruct");
const before = (await text(page, "#caption-a")).replace(/, [\d.]+ ms/, "");
await page.click("#share");
await settle(page);
assert.deepEqual(requests, [], "the page asks for nothing after it has loaded");
const linked = await open({}, new URL(page.url()).hash);
await settle(linked.page);
assert.equal((await text(linked.page, "#caption-a")).replace(/, [\d.]+ ms/, ""), before);
await links(open);
await touch(open);
await screenshots();
assert.deepEqual(problems, []);
const size = brotliCompressSync(await readFile(join(folder, "curvecrust.wasm"))).length;
assert.ok(size <= 300_000, `the module takes ${size} bytes after compression`);
console.log(`module: ${size} bytes after brotli; first picture: ${milliseconds} ms`);
console.log(`a drag of rho on the bunny: ${took.drag.toFixed(1)} ms`);
console.log(`100,000 points: ${took.many.toFixed(1)} ms, native ${expected.milliseconds.toFixed(1)} ms on one thread`);
console.log(`1,000,000 points: ${took.million.toFixed(0)} ms`);
await browser.close();
server.close();
