#!/usr/bin/env bash
# Makes the pages of docs as HTML in a folder: docs/site/build.sh playground/dist/docs. ASSUR names the program.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools=target/site
[ -x "$tools/bin/python" ] || python3 -m venv "$tools"
"$tools/bin/python" -c "import markdown" 2>/dev/null || "$tools/bin/pip" install --quiet 'markdown>=3.6,<4'
"$tools/bin/python" docs/site/build.py "$1"
