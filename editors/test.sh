#!/usr/bin/env bash
# The language server in real editors, without a screen. ASSUR names a program that is built already. An editor that cannot be
# installed is an error.
set -euo pipefail
cd "$(dirname "$0")/.."
export ASSUR=${ASSUR:-$PWD/target/debug/assur}
ASSUR=$(realpath "$ASSUR")
if ! command -v nvim >/dev/null; then
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  $sudo apt-get update -qq
  $sudo apt-get install -y -qq --no-install-recommends neovim
fi
# pytest-lsp: every request once
venv=target/pytest-lsp
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -c 'import pytest_lsp' 2>/dev/null || "$venv/bin/pip" install -q pytest-lsp
timeout 120 "$venv/bin/python" -m pytest -q -p no:cacheprovider -o asyncio_default_fixture_loop_scope=function editors/pytest
# an error in a script leaves Neovim with 0 and the reason on its last lines
said=$(timeout 60 nvim --headless --clean -c "luafile editors/neovim/test.lua" -c "cquit" 2>&1) || { echo "$said" >&2; exit 1; }
echo "$said"
