// The module in a worker of its own: a message in, a message out. It is a classic script, since
// the page starts it from memory: a worker that was cancelled comes back without a request.

let exports = null;

const encode = (header, numbers) => {
  const json = new TextEncoder().encode(JSON.stringify(header));
  const bytes = new Uint8Array(4 + json.length + 8 * numbers.length);
  new DataView(bytes.buffer).setUint32(0, json.length, true);
  bytes.set(json, 4);
  bytes.set(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), 4 + json.length);
  return bytes;
};

const decode = (bytes) => {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  // A copy: the memory of the module is used again, and floats need an aligned start.
  const numbers = new Float64Array(bytes.slice(4 + length).buffer);
  return { header, numbers };
};

const ask = (header, numbers) => {
  const sent = encode(header, numbers);
  const input = exports.curvecrust_input(sent.length);
  if (input === 0) {
    return { header: { error: "There is not enough memory for these points." }, numbers: new Float64Array() };
  }
  new Uint8Array(exports.memory.buffer, input, sent.length).set(sent);
  const answer = exports.curvecrust_answer();
  const length = exports.curvecrust_answer_length();
  return decode(new Uint8Array(exports.memory.buffer, answer, length));
};

self.onmessage = async ({ data }) => {
  if (data.module) {
    exports = (await WebAssembly.instantiate(data.module, {})).exports;
    return;
  }
  const started = performance.now();
  const { header, numbers } = ask(data.header, data.numbers);
  const milliseconds = performance.now() - started;
  self.postMessage({ header, numbers, milliseconds }, [numbers.buffer]);
};
