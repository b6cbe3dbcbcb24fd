// What is fetched stays small; the module is measured where it is that of the release.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { gzipSync } from "node:zlib";

const dist = (name) => new URL(`../dist/${name}`, import.meta.url);

export const sizes = {
  async "sizes: script, module, one file"() {
    const script = gzipSync(readFileSync(dist("playground.js"))).length;
    const [module, whole] = ["assur.wasm.gz", "playground.html"].map((name) => statSync(dist(name)).size);
    const said = `script ${script}, module ${module}, one file ${whole} bytes`;
    assert.ok(script <= 170_000, said);
    // a module for tests is larger
    if ((process.env.PROFILE ?? "wasm") === "wasm") assert.ok(module <= 2_500_000 && whole <= 4_000_000, said);
    return said;
  },
};
