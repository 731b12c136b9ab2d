// What the tests of the page share.

import assert from "node:assert/strict";

export const text = (page, selector) => page.locator(selector).textContent();
export const settle = (page) => page.waitForTimeout(300);

/** Waits until the text of an element is as it should be; what it is else is the error. */
export async function reads(element, pattern, what = "") {
  for (let tries = 0; tries < 100; tries++) {
    if (pattern.test(await element.textContent())) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.match(await element.textContent(), pattern, what);
}

/** Drops a file on the page. */
export async function drop(page, name, content) {
  await page.evaluate(([file, body]) => {
    const data = new DataTransfer();
    data.items.add(new File([body], file));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, content]);
  await settle(page);
}

/** The state in the link of the page. */
export async function stateOf(page) {
  await page.locator("#share").dispatchEvent("click");
  const hash = await page.evaluate(() => location.hash.slice(1));
  return JSON.parse(atob(hash.replaceAll("-", "+").replaceAll("_", "/")));
}

/** A state as the fragment of an address. */
export function fragmentOf(state) {
  const text = btoa(JSON.stringify(state));
  return `#${text.replaceAll("+", "-").replaceAll("/", "_")}`;
}

/** Drags by the mouse from a place of an element to another. */
export async function drag(page, element, from, to) {
  const box = await element.boundingBox();
  await page.mouse.move(box.x + from[0], box.y + from[1]);
  await page.mouse.down();
  await page.mouse.move(box.x + to[0], box.y + to[1], { steps: 6 });
  await page.mouse.up();
  await settle(page);
}

/** Presses keys, one after the other. */
export async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
  await settle(page);
}
