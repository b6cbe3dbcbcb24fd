#!/bin/sh
# Draws the pictures of README.md and docs/pictures.md again. Run it from the root of the repository.
set -e
draw() { cargo run --release --quiet -- draw "$@"; }
draw examples/kinetostatics/six-bar.mech --path coupler.S2 --path crank.B -o docs/pictures/six-bar.svg
draw examples/shaper/shaper-a.mech accelerations --pose 3 -o docs/pictures/shaper-accelerations.svg
