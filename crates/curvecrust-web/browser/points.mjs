// The points of Reconstruct, by keys and by a mouse.

import assert from "node:assert/strict";
import { drag, drop, press, reads, settle, stateOf } from "./page.mjs";

const pointsOf = async (page) => (await stateOf(page)).reconstruct.points;
const words = (page) => page.locator("#reason");

async function triangle(page) {
  await page.click("[data-change=clear]");
  await drop(page, "a.csv", "x,y\n0,0\n10,0\n5,8\n");
}

/** The place of a point of the triangle in the left picture. */
async function pixelOf(page, [x, y]) {
  const [width, height] = await page.evaluate(() => {
    const canvas = document.getElementById("canvas-a");
    return [canvas.clientWidth, canvas.clientHeight];
  });
  const scale = Math.min((width - 52) / 10, (height - 52) / 8);
  return [width / 2 + scale * (x - 5), height / 2 - scale * (y - 4)];
}

/** Takes a point by the cross, moves it, and leaves it. */
async function byCross(page) {
  await page.check("[name=tool][value=move]");
  const before = await pointsOf(page);
  await page.focus("#canvas-a");
  const [[, middle], [, top]] = [await pixelOf(page, [5, 4]), await pixelOf(page, [5, 8])];
  for (let up = 0; up < middle - top - 12; up += 24) await page.keyboard.press("Shift+ArrowUp");
  await press(page, "Enter");
  await reads(words(page), /^Point 2 at 5, 8, one of 3/);
  await press(page, "ArrowRight", "Enter", "ArrowRight");
  const after = await pointsOf(page);
  const moved = before.map((value, i) => value !== after[i]);
  assert.deepEqual(moved.slice(0, 4), [false, false, false, false], "one point moves alone");
  assert.ok(moved[4] && after[4] > before[4], `${before} / ${after}`);
  await page.check("[name=tool][value=add]");
}

/** Everything without a pointer. */
export async function keys(page) {
  await triangle(page);
  await byCross(page);
  await triangle(page);
  const before = await pointsOf(page);
  await page.focus("#canvas-a");
  await page.keyboard.press("Tab");
  const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
  assert.equal(outline, "solid", "the focus is visible");
  await press(page, ",", ".", ".");
  await reads(words(page), /^Point 1 at 10, 0, one of 3/);
  await press(page, "ArrowLeft");
  const short = before[2] - (await pointsOf(page))[2];
  await press(page, "Shift+ArrowLeft");
  const long = before[2] - short - (await pointsOf(page))[2];
  assert.ok(short > 0 && Math.abs(long - 8 * short) < 1e-9, `${short}, with Shift ${long}`);
  await press(page, "a");
  await reads(words(page), /^Point 3 .* one of 4/, "the new point is held");
  await press(page, "ArrowUp", "Delete");
  await reads(words(page), /^Point 3 removed, 3 are left. Point 2 at/);
  await reads(page.locator("#caption-b"), /3 edges/);
  await press(page, "Escape", "Escape");
  await reads(words(page), /^$/);
  await press(page, "ArrowDown", "a");
  assert.equal((await pointsOf(page)).length, 8, "one at the cross");
  for (let i = 0; i < 3; i++) await page.click("[data-change=undo]");
  await settle(page);
  assert.equal((await pointsOf(page)).length, 6);
  const { role, name, described } = await page.evaluate(() => {
    const canvas = document.getElementById("canvas-a");
    const hint = document.getElementById(canvas.getAttribute("aria-describedby"));
    return { role: canvas.role, name: canvas.ariaLabel, described: hint.textContent };
  });
  assert.ok(role === "application" && /points/.test(name) && /arrows/.test(described));
}

export async function dragging(page) {
  await triangle(page);
  await page.check("[name=tool][value=move]");
  const picture = page.locator("#canvas-a");
  const [from, to] = [await pixelOf(page, [5, 8]), await pixelOf(page, [4, 7])];
  await drag(page, picture, from, to);
  const [x, y] = (await pointsOf(page)).slice(4);
  assert.ok(Math.hypot(x - 4, y - 7) < 0.05, `${x}, ${y}`);
  await page.click("[data-change=undo]");
  assert.deepEqual((await pointsOf(page)).slice(4), [5, 8], "a drag is one step");
  await page.check("[name=tool][value=erase]");
  await picture.click({ position: { x: from[0], y: from[1] } });
  assert.equal((await pointsOf(page)).length, 4);
  await page.check("[name=tool][value=add]");
  await page.click("[data-change=clear]");
  await drop(page, "a.csv", "x,y\n0,0\n1,1\n1,0\n0,1\n");
}
