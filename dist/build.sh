#!/usr/bin/env bash
# Makes all packages, and publishes nothing: archive, wheels, source of the Python package, Debian package, extension of VS Code,
# playground, checksums. PROFILE is `dist`; FEATURES are those of the program. What lacks on this machine is left out, and said.
set -euo pipefail
cd "$(dirname "$0")/.."
profile=${PROFILE:-dist}
features=${FEATURES:-parquet,pdf,gif}
out=$PWD/target/artefacts
tools=$PWD/target/python/tools
version=$(sed -n '/^\[workspace.package\]/,/^$/s/^version = "\(.*\)"/\1/p' Cargo.toml)
target=$(rustc -vV | sed -n 's/^host: //p')

rm -rf "$out"
mkdir -p "$out"

echo "program: profile $profile, features $features"
cargo build --quiet --profile "$profile" --features "$features" --bin assur
program=target/$profile/assur

# what an installation adds: the same tree in the archive and in the Debian package
tree=$out/assur-$version-$target
install -D -m 755 "$program" "$tree/bin/assur"
share=$tree/share
mkdir -p "$share/man/man1" "$share/doc/assur/docs"
"$program" man >"$share/man/man1/assur.1"
for command in $("$program" help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  "$program" man "$command" >"$share/man/man1/assur-$command.1"
done
complete() { mkdir -p "$(dirname "$share/$2")" && "$program" completions "$1" >"$share/$2"; }
complete bash bash-completion/completions/assur
complete zsh zsh/vendor-completions/_assur
complete fish fish/vendor_completions.d/assur.fish
complete elvish elvish/lib/assur.elv
complete powershell powershell/assur.ps1
cp README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE "$share/doc/assur/"
cp docs/*.md "$share/doc/assur/docs/"
cp -r examples "$share/doc/assur/examples"
tar -C "$out" --sort=name --owner=0 --group=0 --mtime=@0 -cf - "assur-$version-$target" | gzip -n9 >"$tree.tar.gz"

echo "Debian package"
if command -v dpkg-deb >/dev/null; then
  command -v cargo-deb >/dev/null || [ -x target/tools/bin/cargo-deb ] ||
    CARGO_TARGET_DIR=target/tools/build cargo install --quiet --locked --root target/tools cargo-deb --version '^3'
  rm -rf target/tools/build
  # the package takes its files from one place, whatever the version and the target
  ln -sfn "$tree" target/artefacts/tree
  PATH=$PWD/target/tools/bin:$PATH cargo deb --quiet --no-build --no-strip --profile "$profile" --output "$out/"
  rm target/artefacts/tree
else
  echo "  left out: no dpkg-deb"
fi

echo "Python package"
[ -x "$tools/bin/maturin" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet 'maturin>=1.16,<2'; }
maturin() { (cd crates/assur-python && "$tools/bin/maturin" "$@" --out "$out"); }
# in the profile and with the features that its tests take: it stays below 8 MB
maturin build --quiet --profile release --strip
# of the versions that PyO3 supports
free=$(compgen -c python3 | grep -E '^python3\.(1[4-9]|[2-9][0-9])t$' | sort -u || true)
for python in $free; do
  # the stable ABI is not of free-threaded Python: it has a wheel of its own
  maturin build --quiet --profile release --strip --interpreter "$python"
done
[ -n "$free" ] || echo "  left out: the wheel of free-threaded Python, of which there is none (python3.14t)"
# it has no --quiet
maturin sdist 2>&1 | tail -1

echo "extension of VS Code"
if [ -f editors/vscode/mech.vsix ]; then
  cp editors/vscode/mech.vsix "$out/"
elif command -v npm >/dev/null && [ -d editors/vscode/node_modules ]; then
  (cd editors/vscode && npm run --silent package >/dev/null) && cp editors/vscode/mech.vsix "$out/"
else
  echo "  left out: no node, or its packages are not installed (editors/install.sh)"
fi

echo "playground"
if command -v npm >/dev/null && [ -d playground/node_modules ]; then
  editors/vscode/wasm.sh
  (cd playground && ASSUR=$PWD/../$program npm run --silent build)
  cp playground/dist/playground.html "$out/assur-playground-$version.html"
  tar -C playground --sort=name --owner=0 --group=0 --mtime=@0 -cf - --transform "s|^dist|assur-playground-$version|" dist | gzip -n9 >"$out/assur-playground-$version.tar.gz"
else
  echo "  left out: no node, or its packages are not installed (editors/install.sh)"
fi

rm -rf "$tree"
(cd "$out" && sha256sum -- * >SHA256SUMS)
(cd "$out" && ls -l)
