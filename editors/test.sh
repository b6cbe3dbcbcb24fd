#!/usr/bin/env bash
# The language server and the grammars in real editors, without a screen. ASSUR names a program that is built already.
set -euo pipefail
cd "$(dirname "$0")/.."
export ASSUR=${ASSUR:-$PWD/target/debug/assur}
ASSUR=$(realpath "$ASSUR")

editors/install.sh

tools=target/editors
# Clients of a server: every request once by pytest-lsp, Neovim, Emacs.
clients() {
  ASSUR=$1 timeout 120 "$tools/bin/python" -m pytest -q -p no:cacheprovider -o asyncio_default_fixture_loop_scope=function editors/pytest
  # an error in a script leaves Neovim with 0 and the reason on its last lines
  for script in test fixes colours; do
    said=$(ASSUR=$1 timeout 60 nvim --headless --clean -c "luafile editors/neovim/$script.lua" -c "cquit" 2>&1) || { echo "$said" >&2; exit 1; }
    echo "$said"
  done
  ASSUR=$1 timeout 60 emacs --batch -l editors/emacs/test.el 2>&1 | tail -n 1
}

clients "$ASSUR"
editors/vscode/test.sh
# the same with the server that the extension has inside
clients "$PWD/editors/built-in"

# the page of `assur preview`
tests/pictures/browser/preview.py

# Every grammar against the tokens of `assur`.
"$tools/bin/pygmentize" -l mech -F raiseonerror -f null examples/crank-slider.mech >/dev/null
"$tools/bin/python" editors/tree-sitter-mech/corpus.py
tokens=target/tmp/tokens.txt
if [ ! -f "$tokens" ] || [ -n "$(find examples -name '*.mech' -newer "$tokens" -print -quit)" ]; then
  cargo test --test repository editors
fi
"$tools/bin/python" editors/agreement.py

# the editors that cannot be installed: what they are given, by the rules of their manuals
"$tools/bin/python" editors/others.py
