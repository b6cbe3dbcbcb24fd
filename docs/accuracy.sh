#!/usr/bin/env bash
# Writes docs/accuracy.md and its diagrams. The times are those of this machine.
set -euo pipefail
cd "$(dirname "$0")/.."
# ASSUR names a program that is built already
if [ -z "${ASSUR:-}" ]; then
  cargo build --release --quiet --features lanes
fi
assur=${ASSUR:-target/release/assur}
mkdir -p docs/accuracy

# problem FILE NAME: the comment comes on standard input.
problem() {
  "$assur" accuracy "$1" --format markdown --plot "docs/accuracy/$2.svg" > "docs/accuracy/$2.part"
  echo
  sed -n '1s/^# \(.*\) (.*)$/## \1/p' "docs/accuracy/$2.part"
  echo
  echo "[$1](../$1)"
  echo
  cat
  echo
  echo "![error against time](accuracy/$2.svg)"
  sed -e 1d -e 's/^##/###/' "docs/accuracy/$2.part"
  rm "docs/accuracy/$2.part"
}

{
  cat <<'TEXT'
# What accuracy costs

Written by

```sh
docs/accuracy.sh
```

from what `assur accuracy FILE` measures; [language.md](language.md) explains the errors and their reference.
The times are those of one machine; on another machine the ratios between the rows of a table change little. Points at the
lower left are fast and accurate.

A time per position includes motion, loads and forces, as far as the file asks for them, from the sine and the cosine of the drive,
which are given. It does not include following the motion from position to position, residuals, and writing answers. A time per cycle
is that of all functions over the sweep, with the sines and the following of their samples. The time of a whole solve includes everything from the
text to the report.

Common results of the seven problems:

- Positions are fast. A whole `assur solve`, from text to report, takes from seventy to some thousand times as long as the
  positions in it, so that the scalar and the tolerances of a position make no difference there. They make a difference if the
  library solves millions of positions.
- One position at a time, `f32` saves a few per cent at most: the same divisions and roots wait for one another. Lanes save much
  more, with all digits of `f64`.
- Newton's methods double the digits with every step: a looser tolerance saves one step, and the last step costs little.
- Fewer samples save three fifths of the time of a cycle. For a whole solve of the shaper this is an eighth.
- Double-double is useful where `f64` has lost digits: near dead positions and in long chains.
- `--within` guarantees an accuracy, or reaches one that `f64` does not have. It saves no noticeable time: in `solve` the
  comparison with the reference takes the time that looser tolerances save, and a row of a `batch` takes a quarter to a third longer.
TEXT
  problem examples/accuracy/four-bar.mech four-bar <<'TEXT'
All groups have closed forms: there is no iteration, and only the scalar matters. Lanes give all digits of `f64` in a fifth of
its time; twice the digits take about twenty times as long.
TEXT
  problem examples/accuracy/crank-slider-with-friction.mech friction <<'TEXT'
Newton's method on the forces squares the error with each step: a tolerance of two digits gives five, a tolerance of eight
gives thirteen. The last step, to all digits, costs less than a tenth of the position; leaving it out is not worthwhile.
TEXT
  problem examples/shaper/shaper-a.mech shaper <<'TEXT'
The cutting force begins and ends between positions, so that the torque jumps; its mean and the work of the flywheel are integrals
over pieces that end at the jumps. A piece is smooth and converges fast: with a third of the samples the integrals keep ten
digits. The jumps are found once: a root to the last digit costs a few positions more than a root to two digits, which takes no
noticeable time. A third of the time is for following the cycle and searching for the jumps; no setting reduces it.
TEXT
  problem examples/cams/lever.mech cam <<'TEXT'
The law of a cam is evaluated without iteration; the scalar is the only setting.
TEXT
  problem examples/general/class-iii-triad.mech class-iii <<'TEXT'
A plate on three legs has no closed form. Each step of Newton's method from the last position doubles the digits, and its certificate
shows before the step whether it is the last. A position with all digits takes 1.4 times as long as one with four.
TEXT
  problem examples/general/class-iv-group.mech class-iv <<'TEXT'
Any other group is solved by Newton's method for general groups, whose setting is its last step: the error is of the order of the step's square, or
less. After a last step of 1e-6 only rounding errors are left: by default the solver takes one more step, a quarter of the position, to be sure.
TEXT
  problem examples/accuracy/chain-of-40-dyads.mech chain <<'TEXT'
Every dyad passes its error on to the next: of the sixteen digits of `f64` less than thirteen are left at the end of the chain,
of the seven of `f32` less than four. Here `assur solve --within 1e-15` takes double-double, and all digits of the answer are right.
TEXT
} > docs/accuracy.md
