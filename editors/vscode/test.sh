#!/usr/bin/env bash
# The extension of VS Code: grammar, snippets, the package, and VS Code itself in Chromium. ASSUR names the program.
set -euo pipefail
cd "$(dirname "$0")"
export npm_config_audit=false npm_config_fund=false npm_config_ignore_scripts=true npm_config_loglevel=error
npm ci
npm test --silent
npm run --silent package >/dev/null
size=$(stat -c %s mech.vsix)
[ "$size" -le 1500000 ] || { echo "mech.vsix has $size bytes" >&2; exit 1; }

# VS Code's server; its inner packages come by its own list, which `npm ci` finds incomplete
cd test/workbench
npm ci
(cd node_modules/code-server/lib/vscode && npm install --omit=dev)
node test.mjs
