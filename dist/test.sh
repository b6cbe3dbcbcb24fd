#!/usr/bin/env bash
# Tests what dist/build.sh has made: the archive, the Debian package installed and removed, the wheel in a fresh environment, the sources of
# the Python package, and Dask and Ray with two workers. Installs packages by pip; the Debian package needs root.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$PWD/target/artefacts
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
say() { printf '%4d s  %s\n' "$SECONDS" "$*"; }
fail() { echo "$*" >&2; exit 1; }

(cd "$out" && sha256sum --quiet --check SHA256SUMS)
say "checksums"

solves() { "$1" test examples >"$work/tested" 2>"$work/warnings" || fail "$1 does not solve the examples: $(tail -1 "$work/tested")"; }

tar -C "$work" -xzf "$out"/assur-*-*-*.tar.gz
tree=$(echo "$work"/assur-*)
"$tree/bin/assur" info | grep -qF "$tree/share/doc/assur" || fail "the archive does not find its documents"
for file in man/man1/assur.1 man/man1/assur-batch.1 bash-completion/completions/assur zsh/vendor-completions/_assur \
  fish/vendor_completions.d/assur.fish elvish/lib/assur.elv powershell/assur.ps1 doc/assur/LICENSE-MIT doc/assur/LICENSE-APACHE; do
  [ -s "$tree/share/$file" ] || fail "the archive has no $file"
done
solves "$tree/bin/assur"
say "archive"

if ls "$out"/*.deb >/dev/null 2>&1; then
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  installed() { find /usr /etc /opt /var/lib -xdev -path /var/lib/dpkg -prune -o -print 2>/dev/null | grep -v -e __pycache__ -e /var/lib/apt | sort; }
  installed >"$work/before"
  $sudo dpkg --install "$out"/*.deb >/dev/null
  dpkg --listfiles assur >"$work/files"
  for file in /usr/bin/assur /usr/share/man/man1/assur.1.gz /usr/share/bash-completion/completions/assur /usr/share/doc/assur/copyright; do
    grep -qxF "$file" "$work/files" || fail "the Debian package has no $file"
  done
  solves /usr/bin/assur
  if man -w assur-batch >/dev/null 2>&1; then MANWIDTH=80 man assur-batch | grep -q variants || fail "the manual page cannot be read"; fi
  $sudo dpkg --purge assur >/dev/null
  installed >"$work/after"
  diff "$work/before" "$work/after" || fail "the Debian package leaves something behind"
  say "Debian package: installed, solved the examples, removed; nothing is left"
fi

wheel=$(ls "$out"/assur-*-abi3-*.whl)
[ "$(stat -c %s "$wheel")" -le 8000000 ] || fail "the wheel is larger than 8 MB"
python3 -m venv "$work/fresh"
fresh=$work/fresh/bin
"$fresh/pip" install --quiet "$wheel"
"$fresh/pip" list --format freeze | grep -vi -e '^pip=' -e '^setuptools=' | sort | tr '\n' ' '
solves "$fresh/assur"
"$fresh/python" -m assur info --format json >"$work/info"
cat >"$work/guide.py" <<'PYTHON'
"""The blocks of the guide that need NumPy alone; then how long the import takes, best of five."""
import re, subprocess, sys
page = open("docs/python.md", encoding="utf-8").read().partition("\n## Arrow\n")[0]
names = {}
for block in re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
    exec(block, names)
code = "import time; t = time.perf_counter(); import assur; print(time.perf_counter() - t)"
least = min(float(subprocess.check_output([sys.executable, "-c", code])) for _ in range(5))
print(f"import: {1e3 * least:.0f} ms")
PYTHON
"$fresh/python" "$work/guide.py"
"$fresh/pip" install --quiet pytest pyarrow polars joblib pygments
(cd crates/assur-python && "$fresh/python" -m pytest -q -p no:cacheprovider tests/test_pages.py -k "guide or lexer")
cat >"$work/tables.py" <<'PYTHON'
"""The program's tables of columns are those of the package, whatever file they come from and go to."""
import subprocess, sys
import numpy, pyarrow, pyarrow.feather, pyarrow.parquet
import assur

program, folder = sys.argv[1:]
path = "examples/variants/crank-slider.mech"
i = numpy.arange(20_000)
rows = pyarrow.table({"r [mm]": numpy.where(i == 7777, 9000.0, 80.0 + i % 40), "phi [deg]": i * 37 % 36000 / 100})
wanted = pyarrow.table(assur.load(path).batch(rows)).combine_chunks()
assert wanted["error"].null_count == len(i) - 1
pyarrow.parquet.write_table(rows, f"{folder}/rows.parquet")
pyarrow.feather.write_feather(rows, f"{folder}/rows.feather", compression="lz4")
for source, out in [("rows.parquet", "out.feather"), ("rows.feather", "out.parquet")]:
    command = [program, "batch", path, "--variants", f"{folder}/{source}", "--out", f"{folder}/{out}"]
    assert subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 1, "a row does not close"
    read = pyarrow.parquet.read_table if out.endswith("parquet") else pyarrow.feather.read_table
    found = read(f"{folder}/{out}").combine_chunks()
    assert found.equals(wanted) and found.schema.field("Mb").metadata[b"unit"] == b"N*m", (source, out)
PYTHON
"$fresh/python" "$work/tables.py" "$tree/bin/assur" "$work"
say "tables of Arrow and Parquet"
say "wheel: $(stat -c %s "$wheel") bytes, the guide from top to bottom"

for wheel in "$out"/assur-*t-*.whl; do
  [ -e "$wheel" ] || continue
  python=$(basename "$wheel" | sed 's/.*-cp3\([0-9]*\)t-.*/python3.\1t/')
  "$python" -m venv "$work/free"
  "$work/free/bin/pip" install --quiet "$wheel" pytest pyarrow joblib hypothesis
  "$work/free/bin/python" -c 'import sys, assur; assert not sys._is_gil_enabled(), "the module takes the GIL"'
  (cd crates/assur-python && "$work/free/bin/python" -m pytest -q -p no:cacheprovider --ignore tests/clusters tests)
  say "wheel of $python, without a GIL"
done

tar -C "$work" -xzf "$out"/assur-*[0-9].tar.gz
(cd "$work"/assur-*[0-9]/ && CARGO_TARGET_DIR=$work/target cargo check --quiet --locked --package assur-python)
rm -rf "$work/target"
say "sources of the Python package"

"$fresh/pip" install --quiet 'ray[data]' distributed
for cluster in dask ray; do
  (cd crates/assur-python && "$fresh/python" -m pytest -q -p no:cacheprovider tests/clusters/test_$cluster.py)
  say "$cluster: 1,000,000 rows on two workers, one of which was killed"
done
