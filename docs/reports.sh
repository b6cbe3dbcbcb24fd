#!/usr/bin/env bash
# Writes docs/reports: worked solutions of thirteen examples of all chapters, an exercise sheet and its key. Run it from anywhere; ASSUR names a program
# that is built already. The pages are the same on every machine.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ -z "${ASSUR:-}" ]; then
  cargo build --release --quiet
fi
assur=${ASSUR:-target/release/assur}
out=${1:-docs/reports}
mkdir -p "$out"
report() { "$assur" report "examples/$1.mech" "${@:3}" -o "$out/$2.html"; }

report crank-slider crank-slider
report kinetostatics/six-bar six-bar
report slotted/first-kind slotted-group
report general/class-iii-triad class-iii-group
report friction/four-bar friction
report inertia/engine inertia-forces
report flywheel/engine flywheel
report cams/lever cam
report gears/shifted gears
report trains/planetary-gearbox planetary-gearbox
report synthesis/crank-rocker synthesis
report shaper/shaper-b shaper-project
report simulation/rough-double-pendulum motion-under-loads

report kinetostatics/six-bar six-bar-ru --lang ru
report kinetostatics/six-bar six-bar-zh --lang zh
report exercise-set/11-kinetostatics-of-a-six-bar sheet --sheet
report exercise-set/11-kinetostatics-of-a-six-bar key --key
