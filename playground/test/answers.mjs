// The module says what the program says: answers of all examples, diagnostics of a hundred wrong files.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { resolve } from "node:path";
import { promisify } from "node:util";
import { gunzipSync } from "node:zlib";
import { session } from "../module.mjs";

const ROOT = new URL("../../", import.meta.url).pathname;
const ASSUR = resolve(process.env.ASSUR ?? `${ROOT}target/release/assur`);
const started = async () => session(gunzipSync(readFileSync(new URL("../dist/assur.wasm.gz", import.meta.url))));

/** What the program prints, whatever its status. */
async function printed(args) {
  const done = await promisify(execFile)(ASSUR, args, { cwd: ROOT, maxBuffer: 1 << 28 }).catch((error) => error);
  assert.notEqual(done.code, "ENOENT", `there is no program ${ASSUR}: ASSUR names it`);
  return done.stdout;
}

const files = (folder) => readdirSync(ROOT + folder, { recursive: true }).filter((name) => name.endsWith(".mech")).sort().map((name) => `${folder}/${name}`);

/** Those of some files whose JSON, with all answers and diagnostics, differs but for the name of the file. */
async function different(all) {
  const { ask, open, close } = await started();
  const wrong = [];
  for (const file of all) {
    const uri = `untitled:${file}`;
    open(uri, readFileSync(ROOT + file, "utf8"));
    const { result } = ask("assur/write", { uri, what: "solution.json" });
    close(uri);
    const text = result.text.replaceAll(`"file":"${uri}"`, `"file":"${file}"`);
    if (text !== (await printed(["solve", file, "--format", "json"]))) wrong.push(file);
  }
  return wrong;
}

export const answers = {
  async "answers: the JSON of all examples is the program's"() {
    // a module without optimisation takes long for all
    const few = process.env.PROFILE === "dev", all = files("examples").filter((_, i) => !few || i % 5 === 0);
    assert.deepEqual(await different(all), []);
    return `${all.length} examples`;
  },

  async "answers: the diagnostics of 100 wrong files are the program's"() {
    const all = files("tests/errors"), every = Math.floor(all.length / 100);
    const some = all.filter((_, i) => i % every === 0).slice(0, 100);
    assert.equal(some.length, 100);
    assert.deepEqual(await different(some), []);
  },
};
