// Makes `dist`: the page with its module, the examples with their pictures, the element for other pages, the page as one file.
// ASSUR_WASM names the module, plain or as brotli; else the one that editors/vscode/wasm.sh has made, which is called if there is none.

import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliDecompressSync, gzipSync } from "node:zlib";
import { session } from "./module.mjs";

const HERE = fileURLToPath(new URL(".", import.meta.url));
const ROOT = dirname(dirname(join(HERE, "x")));
const DIST = join(HERE, "dist");
const WASM = join(ROOT, "editors/vscode/out/assur.wasm.br");
const version = /^\[workspace\.package\][^[]*?^version = "(.*?)"/ms.exec(readFileSync(join(ROOT, "Cargo.toml"), "utf8"))[1];
const write = (name, content) => {
  mkdirSync(dirname(join(DIST, name)), { recursive: true });
  writeFileSync(join(DIST, name), content);
};

/** The module, as its bytes. */
function compiled() {
  const named = process.env.ASSUR_WASM ?? WASM;
  if (!existsSync(named)) execFileSync(join(ROOT, "editors/vscode/wasm.sh"), { stdio: "inherit" });
  const bytes = readFileSync(named);
  return named.endsWith(".br") ? brotliDecompressSync(bytes) : bytes;
}

/** All examples: name, title, text. */
function examples() {
  const folder = join(ROOT, "examples");
  const names = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".mech")).sort();
  return names.map((file) => {
    const text = readFileSync(join(folder, file), "utf8");
    const name = file.slice(0, -".mech".length).replaceAll("\\", "/");
    return { name, title: /^mechanism "(.*)"/m.exec(text)?.[1] ?? name, text };
  });
}

/** The gallery: its chapters, and a picture of each, in the colours of light. */
async function gallery(all, wasm) {
  const { ask, open, close } = await session(wasm);
  const chapters = Object.entries(JSON.parse(readFileSync(join(HERE, "gallery.json"), "utf8")));
  const place = new Map(chapters.flatMap(([chapter, names]) => names.map((name) => [name, chapter])));
  for (const name of place.keys()) if (!all.some((one) => one.name === name)) throw new Error(`gallery.json: there is no example ${name}`);
  // those of the gallery first, in its order
  const order = [...place.keys()], at = (one) => (order.includes(one.name) ? order.indexOf(one.name) : order.length);
  return [...all].sort((a, b) => at(a) - at(b)).map((one) => {
    const chapter = place.get(one.name) ?? null;
    if (chapter === null) return { ...one, chapter, picture: null };
    const uri = `untitled:${one.name}`;
    open(uri, one.text);
    const { result, error } = ask("assur/draw", { uri, kind: "scheme", theme: "light" });
    if (error) throw new Error(`${one.name}: ${error.message}`);
    close(uri);
    const picture = `examples/${one.name.replaceAll("/", "-")}.svg`;
    write(picture, result.svg[0]);
    return { ...one, chapter, picture };
  });
}

const common = { bundle: true, minify: true, target: "es2022", legalComments: "none", loader: { ".mech": "text" }, define: { VERSION: JSON.stringify(version) } };
const bundled = (from, to, format) => build({ ...common, entryPoints: [join(HERE, from)], outfile: join(DIST, to), format });

/** The page as one file, which works from a disk: a policy with the hash of its script, everything inside. */
function inOneFile(wasm, all) {
  const [page, style, script, worker] = ["index.html", "style.css", "playground.js", "worker.js"].map((name) => readFileSync(join(DIST, name), "utf8"));
  const own = script.replaceAll("</script", "<\\/script");
  const hash = `'sha256-${createHash("sha256").update(own).digest("base64")}'`;
  const data = (id, content) => `<script type="text/plain" id="${id}">${content.replaceAll("</script", "<\\/script")}</script>\n`;
  const packed = (content) => gzipSync(content, { level: 9 }).toString("base64");
  const inner = [
    data("assur-module", packed(wasm)),
    data("assur-worker", worker),
    data("assur-examples", packed(JSON.stringify(all.map((one) => ({ ...one, picture: null }))))),
    `<script type="module">${own}</script>`,
  ];
  return withoutDocs(page)
    .replace("script-src 'self'", () => `script-src ${hash}`)
    .replace("worker-src 'self'", "worker-src blob:")
    .replace("connect-src 'self'; ", "")
    .replace('<link rel="preload" as="fetch" crossorigin href="assur.wasm.gz">\n', "")
    .replace('<link rel="stylesheet" href="style.css">', () => `<style>${style}</style>`)
    .replace('<script src="playground.js" type="module"></script>', () => inner.join(""));
}

/** The pages of docs beside the page, where there are Python and the program; else nothing leads to them. */
function pages() {
  const named = [process.env.ASSUR, join(ROOT, "target/release/assur"), join(ROOT, "target/debug/assur")];
  const program = named.find((one) => one && existsSync(one));
  try {
    if (program === undefined) throw new Error("there is no program: cargo build --release makes it");
    const env = { ...process.env, ASSUR: resolve(program) };
    execFileSync(join(ROOT, "docs/site/build.sh"), [join(DIST, "docs")], { env, stdio: ["ignore", "ignore", "pipe"] });
  } catch (error) {
    write("index.html", withoutDocs(readFileSync(join(DIST, "index.html"), "utf8")));
    console.log(`without the pages of docs: ${String(error.stderr ?? "") || error.message}`);
  }
}

const withoutDocs = (page) => page.replace('<a id="docs" href="docs/tour.html" data-word="docs"></a>\n', "");

rmSync(DIST, { recursive: true, force: true });
const wasm = compiled();
await Promise.all([bundled("src/main.ts", "playground.js", "esm"), bundled("src/worker.ts", "worker.js", "iife"), bundled("embed/assur-mech.ts", "embed/assur-mech.js", "esm")]);
write("index.html", readFileSync(join(HERE, "index.html")));
write("style.css", readFileSync(join(HERE, "style.css"), "utf8") + readFileSync(join(ROOT, "crates/assur-picture/src/animation/player.css"), "utf8"));
write("assur.wasm.gz", gzipSync(wasm, { level: 9 }));
const all = await gallery(examples(), wasm);
write("examples.json", JSON.stringify(all));
write("playground.html", inOneFile(wasm, all));
pages();
const size = (name) => `${name} ${(statSync(join(DIST, name)).size / 1000).toFixed(0)} kB`;
console.log(`dist: ${["playground.js", "worker.js", "assur.wasm.gz", "examples.json", "playground.html"].map(size).join(", ")}`);
