#!/bin/sh
# Draws the pictures of README.md and docs/tour.md again. Run it from the root of the repository; ASSUR names a program that is
# built already.
set -e
draw() { if [ -n "$ASSUR" ]; then "$ASSUR" draw "$@"; else cargo run --release --quiet -- draw "$@"; fi; }
draw examples/press.mech friction -o docs/pictures/press.svg
draw examples/kinetostatics/six-bar.mech --path coupler.S2 --path crank.B -o docs/pictures/six-bar.svg
draw examples/shaper/shaper-a.mech accelerations --pose 3 -o docs/pictures/shaper-accelerations.svg
draw examples/shaper/shaper-a.mech --pose 3 --ghosts 12 -o docs/pictures/shaper.svg
draw examples/shaper/shaper-a.mech velocities --pose 3 -o docs/pictures/shaper-velocities.svg
draw examples/kinetostatics/six-bar.mech lever -o docs/pictures/six-bar-lever.svg
draw examples/friction/four-bar.mech friction -o docs/pictures/four-bar-friction.svg
draw examples/shaper/shaper-a.mech work -o docs/pictures/shaper-work.svg
draw examples/flywheel/engine.mech hodograph rod.S -o docs/pictures/engine-hodograph.svg
draw examples/contacts/geneva-turns.mech --pose 1 -o docs/pictures/geneva.svg
draw examples/trains/planetary-gearbox.mech train -o docs/pictures/planetary-gearbox.svg
draw examples/trains/two-stage-hoist.mech train -o docs/pictures/two-stage-hoist.svg
draw examples/friction/wedges-forward.mech friction -o docs/pictures/wedges-friction.svg
