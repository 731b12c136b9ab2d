// The figures of Learn that can be dragged.

import { press, reads } from "./page.mjs";

const part = (page, number) => page.locator("#learn section").nth(number - 1);

/** s, dragged across, has another nearest neighbour; by keys too. */
export async function figureOf3(page) {
  const section = part(page, 3);
  const words = () => section.locator(".readout");
  await section.locator("canvas").focus();
  await press(page, ".");
  await reads(words(), /^Point s, 1 of 7, at 50.00, 50.00/);
  await press(page, "Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowLeft");
  await press(page, "Enter", ".", ".");
  await reads(words(), /^Point n, 3 of 7/, "the nearest one is another now");
}
