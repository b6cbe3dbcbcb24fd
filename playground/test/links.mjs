// Links hold every text, and no link breaks the page.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { buildSync } from "esbuild";

const made = buildSync({ entryPoints: [new URL("../src/link.ts", import.meta.url).pathname], bundle: true, format: "esm", write: false });
export const { encode, decode } = await import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].contents).toString("base64")}`);

/** Numbers that look random and are the same every time. */
function random(seed) {
  let state = seed;
  return (below) => {
    state = (state * 48271) % 2147483647;
    return state % below;
  };
}

const SIGNS = ["a", "B", " ", "\n", "\r\n", "\t", "φ₁", "机构", "шатун", "🙂", "<b>", "&amp;", '"', "'", "\u0000", "\ufeff", "{", "// ", "0.1"];

/** Links that are cut, foreign, too new, or unfold to too much; the last is what they are found to be. */
export async function broken() {
  const good = await encode("mech 1\nlink a A-B 1 m\n", "0.1.0");
  const huge = await encode(" ".repeat(3_000_000), "0.1.0");
  return [
    ...[1, 2, 5, 9].map((cut) => [good.slice(0, -cut), "broken"]),
    [huge, "broken"],
    [good.replace("#1/", "#2/"), "newer"],
    [good.replace("#1/", "#99/"), "newer"],
    [good.replace("#1/", "#0/"), "broken"],
    ["#1/", "broken"],
    ["#1/0.1.0/", "broken"],
    ["#1/0.1.0/!!!!", "broken"],
    ["#1/0.1.0/AAAA", "broken"],
    ["#1/0.1.0/____", "broken"],
    ["#/", "broken"],
    ["#1", "broken"],
    ["#hello", "broken"],
    ["#<script>alert(1)</script>", "broken"],
    ["#1/<b>/AAAA", "broken"],
    ["#x/../../etc", "example"],
    ["#x/nothing-of-this-name", "example"],
  ];
}

export const links = {
  async "links: 1,000 random texts and all examples come back"() {
    const next = random(7);
    for (let i = 0; i < 1000; i += 1) {
      const text = Array.from({ length: next(400) }, () => SIGNS[next(SIGNS.length)]).join("");
      const link = await decode(await encode(text, "0.1.0"));
      assert.deepEqual(link, { kind: "text", text, version: "0.1.0" });
    }
    const all = JSON.parse(readFileSync(new URL("../dist/examples.json", import.meta.url), "utf8"));
    const lengths = [];
    for (const { text } of all) {
      const hash = await encode(text, "0.1.0");
      lengths.push(hash.length);
      assert.equal((await decode(hash)).text, text);
    }
    lengths.sort((a, b) => a - b);
    const short = lengths.filter((one) => one <= 2000).length;
    return `${short} of ${all.length} examples within 2,000 characters, the longest ${lengths.at(-1)}`;
  },

  async "links: 20 broken ones are known"() {
    const all = await broken();
    assert.equal(all.length, 20);
    for (const [hash, kind] of all) assert.equal((await decode(hash)).kind, kind, hash.slice(0, 60));
  },
};
