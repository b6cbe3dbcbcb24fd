#!/usr/bin/env bash
# Installs what editors/test.sh and the tests of the playground need and is not there yet. An editor that cannot be installed is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()
command -v nvim >/dev/null || missing+=(neovim)
command -v emacs >/dev/null || missing+=(emacs-nox)
[ -d /usr/share/emacs/site-lisp/elpa-src ] && ls /usr/share/emacs/site-lisp/elpa-src | grep -q '^eglot' || missing+=(elpa-eglot)
command -v chromium >/dev/null || missing+=(chromium)
command -v npm >/dev/null || missing+=(nodejs npm)
command -v cc >/dev/null || missing+=(gcc libc6-dev)
if [ ${#missing[@]} -gt 0 ]; then
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  $sudo apt-get update -qq
  $sudo apt-get install -y -qq --no-install-recommends "${missing[@]}"
fi

tools=target/editors
[ -x "$tools/bin/python" ] || python3 -m venv "$tools"
"$tools/bin/pip" install --quiet pytest-lsp tree-sitter ./editors/pygments

export npm_config_audit=false npm_config_fund=false npm_config_ignore_scripts=true npm_config_loglevel=error
# only where the list has changed
packages() { [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci; }
cd playground
packages
cd ../editors/vscode
packages
# VS Code's server; its inner packages come by its own list, which `npm ci` finds incomplete
cd test/workbench
packages
cd node_modules/code-server/lib/vscode
[ -d node_modules ] || npm install --omit=dev
