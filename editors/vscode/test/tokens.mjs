// Prints the tokens of files by the TextMate grammar: the file's name, then per token its bytes and its scope.
// node tokens.mjs ROOT FILES…
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const require = createRequire(import.meta.url);
const oniguruma = require("vscode-oniguruma");
const { INITIAL, Registry, parseRawGrammar } = require("vscode-textmate");

const wasm = readFileSync(join(require.resolve("vscode-oniguruma"), "../onig.wasm"));
await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
const path = new URL("../syntaxes/mech.tmLanguage.json", import.meta.url).pathname;
const registry = new Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => parseRawGrammar(readFileSync(path, "utf8"), path),
});
const grammar = await registry.loadGrammar("source.mech");

const [root, ...files] = process.argv.slice(2);
const out = [];
for (const file of files) {
  out.push(file);
  let at = 0;
  let state = INITIAL;
  for (const line of readFileSync(join(root, file), "utf8").split("\n")) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    state = ruleStack;
    for (const { startIndex, endIndex, scopes } of tokens) {
      const text = line.slice(startIndex, endIndex);
      const before = at + Buffer.byteLength(line.slice(0, startIndex));
      if (scopes.length > 1 && text.trim() !== "") out.push(`\t${before} ${before + Buffer.byteLength(text)} ${scopes.at(-1)}`);
    }
    at += Buffer.byteLength(line) + 1;
  }
}
console.log(out.join("\n"));
