// The page: three views, dropped files, the link that holds the state.

import { Lane, load } from "./engine.js";
import { readLink, writeLink } from "./link.js";
import * as learn from "./learn.js";
import * as reconstruct from "./reconstruct.js";
import * as sample from "./sample.js";

const views = { reconstruct, sample, learn };
const reader = new Lane();
let current = "reconstruct";

/** Shows a message until the next thing is done; without a text, hides it. */
export function say(text) {
  const line = document.getElementById("message");
  line.textContent = text ?? "";
  line.hidden = !text;
}

/** Does something; what fails is shown, and the state stays. */
export async function attempt(act) {
  try {
    say();
    return await act();
  } catch (error) {
    say(error.message);
    return null;
  }
}

function select(name, focus = false) {
  current = name;
  for (const view of Object.keys(views)) {
    const tab = document.getElementById(`tab-${view}`);
    tab.setAttribute("aria-selected", String(view === name));
    tab.tabIndex = view === name ? 0 : -1;
    document.getElementById(view).hidden = view !== name;
    if (view === name && focus) tab.focus();
  }
  views[name].enter?.();
}

function listenToTabs() {
  const names = Object.keys(views);
  for (const name of names) {
    const tab = document.getElementById(`tab-${name}`);
    tab.addEventListener("click", () => select(name));
    tab.addEventListener("keydown", ({ key }) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
      if (!step) return;
      select(names[(names.indexOf(name) + step + names.length) % names.length], true);
    });
  }
}

/** Reads a file for the view that is shown. */
export async function open(file) {
  if (!file) return;
  await attempt(async () => {
    if (file.size > 100e6) throw new Error(`${file.name}: more than 100 MB are too much for a page.`);
    const text = await file.text();
    if (current === "sample") return sample.open(file.name, text);
    const found = await reader.ask({ points: { name: file.name, text } });
    if (!found) return null;
    if (current === "learn") select("reconstruct");
    return reconstruct.setPoints(Array.from(found.points), found.format !== "SVG");
  });
}

function listenToDrops() {
  const drops = (on) => document.body.classList.toggle("dropping", on);
  addEventListener("dragover", (event) => {
    event.preventDefault();
    drops(true);
  });
  addEventListener("dragleave", () => drops(false));
  addEventListener("drop", (event) => {
    event.preventDefault();
    drops(false);
    open(event.dataTransfer.files[0]);
  });
  for (const id of ["points-file", "curve-file"]) {
    document.getElementById(id).addEventListener("change", (event) => {
      open(event.target.files[0]);
      event.target.value = "";
    });
  }
}

async function share() {
  await attempt(async () => {
    const state = { view: current, reconstruct: reconstruct.state(), sample: sample.state() };
    writeLink(state);
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    const button = document.getElementById("share");
    button.textContent = "Link copied";
    setTimeout(() => (button.textContent = "Copy link"), 1500);
  });
}

async function start() {
  const [{ curves, points }] = await Promise.all([import("./fixtures.js"), load()]);
  const state = readLink();
  listenToTabs();
  listenToDrops();
  document.getElementById("share").addEventListener("click", share);
  for (const form of document.querySelectorAll("form")) {
    form.addEventListener("submit", (event) => event.preventDefault());
  }
  reconstruct.start({ points, attempt, state: state?.reconstruct });
  sample.start({ curves, attempt, state: state?.sample, toReconstruct });
  learn.start({ curves });
  select(views[state?.view] ? state.view : "reconstruct");
}

function toReconstruct(points) {
  select("reconstruct");
  reconstruct.setPoints(points, false);
}

attempt(start).then(() => (document.documentElement.dataset.ready = "yes"));
