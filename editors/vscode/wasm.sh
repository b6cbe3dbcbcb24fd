#!/usr/bin/env bash
# The language server as WebAssembly, for the package: by brotli it is a quarter smaller than by the package's own compression.
# PROFILE=dev compiles it in a third of the time, for tests: larger, and slower.
set -euo pipefail
cd "$(dirname "$0")/../.."
rustup target list --installed | grep -q wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown
profile=${PROFILE:-wasm}
case $profile in
dev) folder=debug quality=4 settings=(--config profile.dev.debug=false) ;;
*) folder=$profile quality=11 settings=() ;;
esac
cargo build --quiet -p assur-wasm --profile "$profile" "${settings[@]}" --target wasm32-unknown-unknown
mkdir -p editors/vscode/out
node - "target/wasm32-unknown-unknown/$folder/assur_wasm.wasm" editors/vscode/out/assur.wasm.br "$quality" <<'END'
const { readFileSync, writeFileSync } = require("node:fs");
const { brotliCompressSync, constants } = require("node:zlib");
const [from, to, quality] = process.argv.slice(2);
const params = { [constants.BROTLI_PARAM_QUALITY]: Number(quality), [constants.BROTLI_PARAM_LGWIN]: 24 };
writeFileSync(to, brotliCompressSync(readFileSync(from), { params }));
END
