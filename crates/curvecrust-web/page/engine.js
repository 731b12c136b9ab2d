// Questions to the module. A lane is one worker with one question at a time; a newer question
// overtakes the one that waits, and cancels the one that runs if that takes long.

const PATIENCE = 250;
const SLOW = 500;

let source = null;
let module = null;
const running = new Set();

/** Loads all that workers need, once: afterwards nothing is fetched any more. */
export async function load() {
  const [script, wasm] = await Promise.all([
    fetch("worker.js").then((response) => response.text()),
    fetch("curvecrust.wasm").then((response) => response.arrayBuffer()),
  ]);
  source = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  module = await WebAssembly.compile(wasm);
}

/** What an answer with an error throws. */
export class Refusal extends Error {}

/** The arrays of an answer by their names, beside the values of its header. */
function unpack({ header, numbers, milliseconds }) {
  if (header.error) throw new Refusal(header.error);
  const answer = { ...header, milliseconds };
  for (const [name, [start, end]] of Object.entries(header.arrays)) {
    answer[name] = numbers.subarray(start, end);
  }
  return answer;
}

/** Shows the bar when something has run for half a second. */
function showWhenSlow() {
  const bar = document.getElementById("busy");
  const now = performance.now();
  bar.hidden = ![...running].some((lane) => now - lane.since > SLOW);
}

export class Lane {
  #worker = null;
  #current = null;
  #next = null;
  #curve = null;
  #reloads = false;
  since = 0;

  /** An answer, or null if a newer question has overtaken this one. */
  ask(header, numbers = new Float64Array()) {
    return new Promise((resolve, reject) => {
      this.#next?.resolve(null);
      this.#next = { header, numbers, resolve, reject };
      if (this.#current && performance.now() - this.since > PATIENCE) this.#cancel();
      else if (this.#current) setTimeout(() => this.#cancelIfOvertaken(), PATIENCE);
      this.#advance();
    });
  }

  /** The curve that later questions are about. */
  async curve(header) {
    const answer = await this.ask(header);
    if (answer) this.#curve = header;
    return answer;
  }

  #cancelIfOvertaken() {
    if (this.#next && this.#current && performance.now() - this.since >= PATIENCE) {
      this.#cancel();
      this.#advance();
    }
  }

  #cancel() {
    this.#worker.terminate();
    this.#worker = null;
    this.#current.resolve(null);
    this.#current = null;
    running.delete(this);
    // A new worker does not know the curve.
    this.#reloads = this.#curve !== null;
  }

  #start() {
    const worker = new Worker(source);
    worker.onmessage = ({ data }) => this.#finish((job) => job.resolve(unpack(data)));
    worker.onerror = (event) => {
      event.preventDefault();
      this.#finish((job) => job.reject(new Refusal("This was too much for the page.")));
      worker.terminate();
      this.#worker = null;
      this.#reloads = this.#curve !== null;
    };
    worker.postMessage({ module });
    return worker;
  }

  #finish(act) {
    const job = this.#current;
    this.#current = null;
    running.delete(this);
    showWhenSlow();
    if (job) {
      try {
        act(job);
      } catch (error) {
        job.reject(error);
      }
    }
    this.#advance();
  }

  #advance() {
    if (this.#current || !this.#next) return;
    this.#worker ??= this.#start();
    let job = this.#next;
    if (this.#reloads && job.header.curve === undefined) {
      job = { header: this.#curve, numbers: new Float64Array(), resolve() {}, reject() {} };
    } else {
      this.#next = null;
    }
    this.#reloads = false;
    this.#current = job;
    this.since = performance.now();
    running.add(this);
    setTimeout(showWhenSlow, SLOW + 20);
    this.#worker.postMessage({ header: job.header, numbers: job.numbers });
  }
}
