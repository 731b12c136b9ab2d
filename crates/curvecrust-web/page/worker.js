// The module in a worker of its own: a message in, a message out. It is a classic script, since
// the page starts it from memory: a worker that was cancelled comes back without a request.

let exports = null;

const decode = (bytes) => {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  // A copy: the memory of the module is used again, and floats need an aligned start.
  const numbers = new Float64Array(bytes.slice(4 + length).buffer);
  return { header, numbers };
};

const ask = (header, numbers) => {
  const json = new TextEncoder().encode(JSON.stringify(header));
  const input = exports.curvecrust_input(4 + json.length + numbers.byteLength);
  if (input === 0) {
    return { header: { error: "There is not enough memory for these points." }, numbers: new Float64Array() };
  }
  const { buffer } = exports.memory;
  new DataView(buffer).setUint32(input, json.length, true);
  const sent = new Uint8Array(buffer, input + 4);
  sent.set(json);
  sent.set(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), json.length);
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
