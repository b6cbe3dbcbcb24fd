// The module in Node, without a page: for the build and the tests.

const LONGEST = 60_000;

/** A session: `ask` gives what a request answers, `tell` what a notification brings. */
export async function session(wasm) {
  let begun = 0, number = 0;
  const stop = () => (Date.now() - begun > LONGEST ? 2 : 0);
  const compiled = await WebAssembly.compile(wasm);
  const { memory, reserve, free, handle } = (await WebAssembly.instantiate(compiled, { assur: { stop } })).exports;
  const send = (message) => {
    const bytes = new TextEncoder().encode(JSON.stringify({ jsonrpc: "2.0", ...message }));
    const at = reserve(bytes.length) >>> 0;
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    begun = Date.now();
    const back = handle(at, bytes.length) >>> 0;
    const length = new DataView(memory.buffer).getUint32(back, true);
    const text = new TextDecoder().decode(new Uint8Array(memory.buffer, back + 4, length));
    free(back, length + 4);
    return JSON.parse(text);
  };
  const tell = (method, params) => send({ method, params });
  const ask = (method, params) => {
    number += 1;
    return send({ id: number, method, params }).find((one) => one.id === number);
  };
  ask("initialize", { capabilities: {}, initializationOptions: { solved: true } });
  tell("initialized", {});
  /** Opens and solves a text; gives its diagnostics. */
  const open = (uri, text) => {
    tell("textDocument/didOpen", { textDocument: { uri, languageId: "mech", version: 1, text } });
    const said = [...tell("assur/publish"), ...tell("assur/solve")];
    const found = said.filter((one) => one.method === "textDocument/publishDiagnostics" && one.params.uri === uri);
    return found.at(-1)?.params.diagnostics ?? [];
  };
  const close = (uri) => tell("textDocument/didClose", { textDocument: { uri } });
  return { ask, tell, open, close };
}
