// The built-in server in its thread: it draws and says what the program does, stops solving when a message comes, and is ended when a message
// takes too long or the server breaks. ASSUR names the program.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { buildSync } from "esbuild";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const bundle = { bundle: true, platform: "node", format: "cjs", logLevel: "error" };
buildSync({ ...bundle, entryPoints: [here("../src/built-in.ts")], outfile: here("../out/test/built-in.cjs") });
const { load, run } = (await import("../out/test/built-in.cjs")).default;

const examples = ["crank-slider", "first", "flywheel/engine"].map((name) => here(`../../../examples/${name}.mech`));

/** A session over a way to send and a way to listen. */
class Session {
  waiting = new Map();
  told = [];
  count = 0;

  constructor(send) {
    this.send = (message) => send({ jsonrpc: "2.0", ...message });
  }

  take(message) {
    if (message.method) this.told.push(message);
    else this.waiting.get(message.id)?.(message);
  }

  ask(method, params) {
    const id = (this.count += 1);
    this.send({ id, method, params });
    return new Promise((found) => this.waiting.set(id, found));
  }

  async open(uri, text) {
    this.send({ method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "mech", version: 1, text } } });
  }

  /** The picture of a text, once it is solved. */
  async picture(uri) {
    for (let tries = 0; ; tries += 1) {
      const { result, error } = await this.ask("assur/picture", { uri });
      if (result) return result;
      // without optimisation, and on a busy machine, this takes seconds
      assert.ok(tries < 600, error?.message);
      await new Promise((next) => setTimeout(next, 100));
    }
  }

  /** What was said last of a text. */
  diagnostics(uri) {
    const said = this.told.filter(({ method, params }) => method === "textDocument/publishDiagnostics" && params.uri === uri);
    return said.at(-1)?.params.diagnostics;
  }
}

function program() {
  const child = spawn(process.env.ASSUR ?? "assur", ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
  const session = new Session((message) => {
    const body = JSON.stringify(message);
    child.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
  });
  let rest = Buffer.alloc(0);
  child.stdout.on("data", (part) => {
    rest = Buffer.concat([rest, part]);
    for (;;) {
      const end = rest.indexOf("\r\n\r\n");
      const length = Number(/Content-Length: (\d+)/.exec(rest.subarray(0, Math.max(end, 0)).toString())?.[1]);
      if (end < 0 || rest.length < end + 4 + length) return;
      session.take(JSON.parse(rest.subarray(end + 4, end + 4 + length).toString()));
      rest = rest.subarray(end + 4 + length);
    }
  });
  return { session, end: () => child.kill() };
}

const module = await load(here("../out"));
function builtIn() {
  let why;
  const ended = new Promise((told) => (why = told));
  const { reader, writer } = run(here("../out"), module, why);
  const session = new Session((message) => void writer.write(message));
  reader.listen((message) => session.take(message));
  return { session, ended, end: () => writer.end() };
}

const started = async ({ session }) => session.ask("initialize", { capabilities: {} });

const [native, own] = [program(), builtIn()];
await Promise.all([started(native), started(own)]);
for (const path of examples) {
  const text = readFileSync(path, "utf8");
  const uri = `file://${path}`;
  const [theirs, ours] = await Promise.all([native, own].map(({ session }) => (session.open(uri, text), session.picture(uri))));
  assert.deepEqual(ours, theirs, `the picture of ${path}`);
  assert.deepEqual(own.session.diagnostics(uri), native.session.diagnostics(uri), `what is said of ${path}`);
}
native.end();

// a sweep that takes long: a question is answered within it
const slow = readFileSync(examples[0], "utf8").replace(/^drive .*$/m, "drive crank = 0 deg .. 360 deg in 19000 steps at 10 rad/s");
own.session.open("untitled:slow", slow);
await new Promise((next) => setTimeout(next, 300));
const begun = Date.now();
const symbols = await own.session.ask("textDocument/documentSymbol", { textDocument: { uri: "untitled:slow" } });
assert.ok(symbols.result.length > 5);
const waited = Date.now() - begun;
assert.ok(waited < 500, `a question waits ${waited} ms for an answer while a text is solved`);

// a table of very many rows: the server is ended after 5 s
const rows = Array.from({ length: 400_000 }, (_, i) => `${100 + i / 1e4}`).join("\n  ");
own.session.open("untitled:rows", `given r = 100 mm\nfind s = 2*r\nvariants {\n  r [mm]\n  ${rows}\n}\n`);
void own.session.ask("workspace/executeCommand", { command: "assur.test", arguments: ["untitled:rows"] });
assert.match(await own.ended, /within 5 s/);

// another one starts at once
const next = builtIn();
await started(next);
next.end();
console.log(`built-in server: pictures and diagnostics of ${examples.length} examples, an answer after ${waited} ms while it solves, ended and started again`);
