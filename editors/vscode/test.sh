#!/usr/bin/env bash
# The extension of VS Code: grammar, snippets, the package, and VS Code itself in Chromium. ASSUR names the program; editors/install.sh has
# installed what it needs.
set -euo pipefail
cd "$(dirname "$0")"
npm test --silent
npm run --silent package >/dev/null
node test/built-in.mjs
size=$(stat -c %s mech.vsix)
# that of the server for tests is larger
[ "${PROFILE:-wasm}" != wasm ] || [ "$size" -le 2000000 ] || { echo "mech.vsix has $size bytes" >&2; exit 1; }

cd test/workbench
node test.mjs
