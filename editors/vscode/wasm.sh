#!/usr/bin/env bash
# The language server as WebAssembly, for the package: by brotli it is a quarter smaller than by the package's own compression.
set -euo pipefail
cd "$(dirname "$0")/../.."
rustup target list --installed | grep -q wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown
cargo build --quiet -p assur-wasm --profile wasm --target wasm32-unknown-unknown
mkdir -p editors/vscode/out
node - target/wasm32-unknown-unknown/wasm/assur_wasm.wasm editors/vscode/out/assur.wasm.br <<'END'
const { readFileSync, writeFileSync } = require("node:fs");
const { brotliCompressSync, constants } = require("node:zlib");
const [from, to] = process.argv.slice(2);
const params = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 };
writeFileSync(to, brotliCompressSync(readFileSync(from), { params }));
END
