// Strokes that are drawn and bent in Sample: by a mouse, by keys, and by a finger.

import assert from "node:assert/strict";
import { drag, fragmentOf, press, reads, settle, stateOf } from "./page.mjs";

const CLICKED = [[60, 60], [260, 80], [240, 240], [80, 220]];
/** Catmull and Rom's handle after the second one: a sixth of the way from the first to the third. */
const HANDLE = [290, 110];

const strokesOf = async (page) => (await stateOf(page)).sample.strokes;
const words = (page) => page.locator("#node-words");
const caption = (page) => page.locator("#sample-caption");
const picture = (page) => page.locator("#canvas-sample");

async function click(page, [x, y]) {
  await picture(page).click({ position: { x, y } });
  await settle(page);
}

const near = (a, b, within, what) =>
  assert.ok(a.every((v, k) => Math.abs(v - b[k]) <= within), `${what}: ${a} / ${b}`);

/** Places on the first stroke as it is linked, at shares t of one of its segments. */
const placesOn = (page, stroke, segment, shares) =>
  page.evaluate(async ([nodes, index, list]) => {
    const { cubicsOf } = await import("./stroke.js");
    const controls = cubicsOf(nodes, true)[index];
    const mix = (t, row) => row.slice(1).map((q, i) => q.map((v, k) => row[i][k] + t * (v - row[i][k])));
    return list.map((t) => mix(t, mix(t, mix(t, controls)))[0]);
  }, [stroke, segment, shares]);

/** The pixel of a place, from the first two nodes of a stroke and where they were clicked. */
function pixel([[x0, y0], [x1]], [x, y]) {
  const scale = (CLICKED[1][0] - CLICKED[0][0]) / (x1 - x0);
  return [CLICKED[0][0] + scale * (x - x0), CLICKED[0][1] + scale * (y - y0)];
}

/** Draws, adds a point on the curve without a change of the curve, and removes it. */
export async function nodes(page) {
  await page.click("#draw");
  for (const place of CLICKED) await click(page, place);
  await reads(caption(page), /^\d+ samples/);
  const [stroke] = await strokesOf(page);
  assert.deepEqual(stroke.map((node) => node.length), [2, 2, 2, 2]);
  const [quarter, middle, rest] = await placesOn(page, stroke, 1, [0.25, 0.5, 0.75]);
  await click(page, pixel(stroke, middle));
  await reads(words(page), /^Point 3 of 5, smooth/);
  const [after] = await strokesOf(page);
  near(after[2].slice(0, 2), middle, 0.3, "the point that was added");
  for (const [place, segment] of [[quarter, 1], [rest, 2]]) {
    const [half] = await placesOn(page, after, segment, [0.5]);
    near(half, place, 0.3, "the curve stays");
  }
  await page.click("#node-remove");
  await reads(words(page), /^Point removed. Point 3 of 4/);
  // The points beside it keep the handles that they got.
  assert.deepEqual((await strokesOf(page))[0].map((node) => node.length), [2, 7, 7, 2]);
  await page.click("#draw");
  await page.click("#draw");
  for (const place of CLICKED) await click(page, place);
}

/** A drawing with a handle that was dragged. */
export async function bend(page) {
  await page.click("#draw");
  for (const place of CLICKED) await click(page, place);
  await click(page, CLICKED[1]);
  await drag(page, picture(page), HANDLE, [HANDLE[0] + 15, HANDLE[1] + 35]);
}

/** Drags handles, makes a corner and a smooth point again, and opens the link. */
export async function bending(page) {
  await click(page, CLICKED[1]);
  await reads(words(page), /^Point 2 of 4, smooth/);
  const before = await caption(page).textContent();
  await drag(page, picture(page), HANDLE, [320, 90]);
  await reads(words(page), /^Handle after point 2 of 4/);
  await page.waitForFunction((old) => document.getElementById("sample-caption").textContent !== old, before);
  const [stroke] = await strokesOf(page);
  assert.deepEqual(stroke.map((node) => node.length), [2, 7, 2, 2]);
  const [backward, forward] = [stroke[1].slice(2, 4), stroke[1].slice(4, 6)];
  const scale = (CLICKED[1][0] - CLICKED[0][0]) / (stroke[1][0] - stroke[0][0]);
  near(forward.map((v) => v * scale), [60, 10], 0.5, "the handle that was dragged");
  near([Math.hypot(...backward) * scale], [Math.hypot(30, 30)], 0.5, "the other is as long as before");
  const share = Math.hypot(...backward) / Math.hypot(...forward);
  near(backward, forward.map((v) => -share * v), 1e-9, "and opposite");
  await page.check("#node-corner");
  await settle(page);
  await reads(caption(page), /1 corner,/);
  // A third of the way to the third point: without the other handle.
  const third = [0, 1].map((k) => CLICKED[1][k] + (CLICKED[2][k] - CLICKED[1][k]) / 3);
  const [[, corner]] = await strokesOf(page);
  await drag(page, picture(page), third, [third[0] + 30, third[1]]);
  const [[, turned]] = await strokesOf(page);
  assert.deepEqual(turned.slice(0, 4), corner.slice(0, 4));
  assert.ok(turned[4] > corner[4] && turned[6] === 1);
  await reads(caption(page), /1 corner,/);
  await page.uncheck("#node-corner");
  await settle(page);
  await reads(caption(page), /^((?!corner).)*$/);
  assert.deepEqual((await strokesOf(page))[0].map((node) => node.length), [2, 2, 2, 2]);
}

/** A drawing and its bends without a pointer. */
export async function keysOfDrawing(page) {
  await page.click("#draw");
  await page.click("#draw");
  await page.focus("#canvas-sample");
  const right = Array(4).fill("Shift+ArrowRight");
  await press(page, "Enter", ...right, "Enter", ...Array(4).fill("Shift+ArrowDown"), "a");
  await reads(words(page), /^Point 3 of 3, smooth/);
  await reads(caption(page), /^\d+ samples/);
  const [before] = await strokesOf(page);
  await press(page, ",", "ArrowUp", "Shift+ArrowUp");
  const [moved] = await strokesOf(page);
  assert.ok(moved[2][1] < before[2][1] || moved[1][1] < before[1][1], "arrows move what is held");
  await press(page, ".", ".", "h", "h");
  await reads(words(page), /^Handle after point 1 of 3/);
  await press(page, "Shift+ArrowUp", "h", "c");
  await reads(words(page), /^Point 1 of 3, a corner/);
  await reads(caption(page), /1 corner,/);
  await press(page, "c", "a");
  await reads(words(page), /^Point 2 of 4, smooth/);
  await press(page, "Delete", "Delete", "Backspace");
  assert.equal((await strokesOf(page))[0].length, 1);
  await reads(caption(page), /^Click to add points/, "too few points have no curve");
  await press(page, "Escape", "Escape");
  await reads(words(page), /^No point is selected/);
  assert.ok(await page.locator("#node-remove").isDisabled());
  assert.equal(await page.getAttribute("#node-words", "aria-live"), "polite");
}

/** Links from before there were handles, links with handles, and what is none. */
export async function links(open) {
  const pairs = [[[10, 10], [60, 20], [50, 60]]];
  const handles = [[[10, 10], [60, 20, 0, -15, 0, 20, 0], [50, 60, 5, -5, -9, 0, 1]]];
  for (const strokes of [pairs, handles]) {
    const state = { view: "sample", sample: { strokes, closed: true, rho: "0.8" } };
    const { page } = await open({}, fragmentOf(state));
    await settle(page);
    await reads(caption(page), strokes === pairs ? /^\d+ samples/ : /1 corner,/);
    assert.deepEqual(await strokesOf(page), strokes);
    await page.close();
  }
  const { page: empty } = await open({}, fragmentOf({ view: "sample", sample: { strokes: [] } }));
  await click(empty, CLICKED[0]);
  await reads(words(empty), /^Point 1 of 1/);
  await empty.close();
  for (const strokes of [[[[1, 2, 3]]], [[["a", "b"]]], [7], [[[1, 2], null]]]) {
    const { page } = await open({}, fragmentOf({ view: "sample", sample: { strokes } }));
    await page.waitForFunction(() => document.getElementById("curve-fixture").value === "bunny");
    await page.close();
  }
}

/** Draws and bends with a finger, which is less exact than a mouse. */
export async function touch(open) {
  const { page } = await open({ viewport: { width: 360, height: 800 }, hasTouch: true, isMobile: true });
  await page.tap("#tab-sample");
  await page.tap("#draw");
  for (const [x, y] of CLICKED.map((place) => place.map((v) => v * 0.9))) {
    await picture(page).tap({ position: { x, y } });
    await settle(page);
  }
  await picture(page).tap({ position: { x: 0.9 * 260 - 12, y: 0.9 * 80 - 9 } });
  await reads(words(page), /^Point 2 of 4/, "a finger may miss by 15 pixels");
  const box = await picture(page).boundingBox();
  const client = await page.context().newCDPSession(page);
  const send = (type, ...at) =>
    client.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: at.map(([x, y]) => ({ x: box.x + x, y: box.y + y })),
    });
  await send("touchStart", [0.9 * HANDLE[0] + 14, 0.9 * HANDLE[1] + 6]);
  for (const step of [5, 15, 30]) await send("touchMove", [0.9 * HANDLE[0] + 14 + step, 0.9 * HANDLE[1]]);
  await send("touchEnd");
  await settle(page);
  await reads(words(page), /^Handle after point 2 of 4/);
  assert.equal((await strokesOf(page))[0][1].length, 7);
  await page.close();
}
