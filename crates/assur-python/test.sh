#!/usr/bin/env bash
# Builds the wheel and tests it in a fresh environment. PROFILE=test takes the crates that `cargo test` has compiled, with less
# optimisation; arguments go to pytest.
set -euo pipefail
cd "$(dirname "$0")"
target=$(cd ../.. && pwd)/target/python
profile=${PROFILE:-release}

[ -x "$target/tools/bin/maturin" ] || { python3 -m venv "$target/tools" && "$target/tools/bin/pip" install --quiet 'maturin>=1.16,<2'; }
rm -rf "$target/wheels"
build=(--profile "$profile" --strip)
if [ "$profile" = test ]; then
  # the settings of the tests under the name of the profile that maturin can build
  awk '/^\[/ { own = /^\[profile\.test/ } own { sub(/profile\.test/, "profile.dev"); print }' ../../Cargo.toml >"$target/profile.toml"
  build=(--profile dev --config "$target/profile.toml")
fi
"$target/tools/bin/maturin" build --quiet "${build[@]}" --out "$target/wheels"

# NumPy alone is needed by the package, the others by its tests
rm -rf "$target/fresh"
python3 -m venv "$target/fresh"
"$target/fresh/bin/pip" install --quiet "$target"/wheels/assur-*.whl
"$target/fresh/bin/python" -c 'import assur; assert assur.load("../../examples/crank-slider.mech").solve()["Mb"][0] > 0'
"$target/fresh/bin/pip" install --quiet pytest pytest-xdist pyarrow polars joblib dask ipython hypothesis
"$target/fresh/bin/python" -m pytest -q -p no:cacheprovider "$@"
