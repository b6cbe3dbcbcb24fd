#!/usr/bin/env bash
# The language server and the grammars in real editors, without a screen. ASSUR names a program that is built already. An editor
# that cannot be installed is an error.
set -euo pipefail
cd "$(dirname "$0")/.."
export ASSUR=${ASSUR:-$PWD/target/debug/assur}
ASSUR=$(realpath "$ASSUR")

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

# an error in a script leaves Neovim with 0 and the reason on its last lines
for script in test fixes colours; do
  said=$(timeout 60 nvim --headless --clean -c "luafile editors/neovim/$script.lua" -c "cquit" 2>&1) || { echo "$said" >&2; exit 1; }
  echo "$said"
done

timeout 60 emacs --batch -l editors/emacs/test.el 2>&1 | tail -n 1

editors/vscode/test.sh

# Every grammar against the tokens of `assur`.
tools=target/editors
[ -x "$tools/bin/python" ] || python3 -m venv "$tools"
"$tools/bin/pip" install --quiet tree-sitter ./editors/pygments
"$tools/bin/pygmentize" -l mech -F raiseonerror -f null examples/crank-slider.mech >/dev/null
"$tools/bin/python" editors/tree-sitter-mech/corpus.py
tokens=target/tmp/tokens.txt
if [ ! -f "$tokens" ] || [ -n "$(find examples -name '*.mech' -newer "$tokens" -print -quit)" ]; then
  cargo test --test repository editors
fi
"$tools/bin/python" editors/agreement.py
