#!/usr/bin/env bash
# Writes docs/measured/accuracy.md and its diagrams. The times are those of this machine.
set -euo pipefail
cd "$(dirname "$0")/../.."
# ASSUR names a program that is built already
if [ -z "${ASSUR:-}" ]; then
  cargo build --release --quiet
fi
assur=${ASSUR:-target/release/assur}
mkdir -p docs/measured/accuracy

# problem FILE NAME: the comment comes on standard input.
problem() {
  "$assur" accuracy "$1" --plot "docs/measured/accuracy/$2.svg" > "docs/measured/accuracy/$2.part"
  echo
  sed -n '1s/^\(.*\) (.*)\(: what accuracy costs\)$/## \1/p' "docs/measured/accuracy/$2.part"
  echo
  cat
  echo
  echo "![price of effects and digits](accuracy/$2.svg)"
  echo
  echo '```text'
  cat "docs/measured/accuracy/$2.part"
  echo '```'
  rm "docs/measured/accuracy/$2.part"
}

{
  cat <<'TEXT'
# What accuracy costs

![price of effects and digits in a crank-slider with friction](accuracy/friction.svg)

An effect that is not asked for takes no time. Friction takes more time than all others together. Fewer digits save a fifth at most; twice the digits
take some hundred times as long. This page is for developers; [../accuracy.md](../accuracy.md) is for users.

Written by

```sh
docs/measured/accuracy.sh
```

from what `assur accuracy FILE` prints; `--details` has the tables of every setting, and [commands.md](../commands.md#accuracy) explains the errors and their
reference. The times are those of one machine; on another machine their ratios change little.

A time per position includes the motion, loads and forces that the file asks for. The sine and the cosine of the drive are given. Following the motion from position to
position, residuals, and writing answers are not included. The time of functions over the sweep includes following their samples. "All together" are all positions and
functions of the file, with the comparison that `--within` needs.

Common results of the eight problems:

- The file as it is has all digits of `f64`, and is recommended. Newton's methods double the digits with every step: a looser tolerance saves one step.
- Fewer samples save three fifths of the time of functions over the sweep.
- `--within` guarantees an accuracy: it compares positions with double-double, which takes longer than looser tolerances save.
- Double-double is useful where `f64` has lost digits: near dead positions and in long chains.
TEXT
  problem examples/accuracy/four-bar.mech four-bar <<'TEXT'
All groups have closed forms: there is no iteration, and nothing to save.
TEXT
  problem examples/accuracy/crank-slider-with-friction.mech friction <<'TEXT'
Newton's method on the forces squares the error with each step, and starts near: the last step takes little.
TEXT
  problem examples/friction/toggle-press-working.mech press <<'TEXT'
Most of the time is friction. The work of a press is one position here: nothing is gained by fewer digits.
TEXT
  problem examples/shaper/shaper-a.mech shaper <<'TEXT'
The cutting force begins and ends between positions, so that the torque jumps; its mean and the work of the flywheel are integrals
over pieces that end at the jumps. A piece is smooth and converges fast: with a third of the samples the integrals keep ten digits.
TEXT
  problem examples/cams/lever.mech cam <<'TEXT'
The law of a cam is evaluated without iteration; most of the time is for its contact.
TEXT
  problem examples/general/class-iii-triad.mech class-iii <<'TEXT'
A plate on three legs has no closed form. Each step of Newton's method from the last position doubles the digits, and its certificate
shows before the step whether it is the last.
TEXT
  problem examples/general/class-iv-group.mech class-iv <<'TEXT'
Any other group is solved by Newton's method for general groups, whose last step squares the error.
TEXT
  problem examples/accuracy/chain-of-40-dyads.mech chain <<'TEXT'
Every dyad passes its error on to the next: of the sixteen digits of `f64` less than thirteen are left at the end of the chain.
Here `assur solve --within 1e-15` takes double-double, and all digits of the answer are right.
TEXT
} > docs/measured/accuracy.md
