#!/usr/bin/env bash
# Writes docs/accuracy.md and the diagrams beside it. Times are those of the machine it runs on.
set -euo pipefail
cd "$(dirname "$0")/.."
# ASSUR names a program that is built already
if [ -z "${ASSUR:-}" ]; then
  cargo build --release --quiet --features lanes
fi
assur=${ASSUR:-target/release/assur}
mkdir -p docs/accuracy

# problem FILE NAME: what it teaches comes on standard input.
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

from what `assur accuracy FILE` measures; [language.md](language.md) says what the errors are relative to and what they are held
against. Times are those of one machine and change with it; the ratios between the rows of a table change little. Points to the
lower left are cheap and accurate.

What the seven problems have in common:

- Positions are cheap. A whole `assur solve`, from text to report, takes from seventy to some thousand times as long as the
  positions in it, so that no scalar and no tolerance of a position is felt there. They are felt where positions are solved by the
  million through the library.
- `f32` saves a few per cent at most, one position at a time: the same divisions and roots wait for one another. What makes
  positions cheap is lanes, at the full digits of `f64`.
- Newton's methods double the digits with every step: a looser tolerance saves one step, and the last step costs little.
- Fewer samples save three fifths of the time of a cycle. Of a whole solve of the shaper that is an eighth.
- Double-double pays where `f64` has lost digits: near dead positions and in long chains.
- `--within` is there to be sure of an accuracy, or to reach one that `f64` has not. It saves no time that could be told: in `solve`
  what it loosens pays for holding the answers against the reference, and a row of a `batch` takes a quarter to a third longer.
TEXT
  problem examples/accuracy/four-bar.mech four-bar <<'TEXT'
All groups have closed forms: there is nothing to iterate, and the scalar alone decides. Lanes give all digits of `f64` in a fifth of
its time; twice the digits take some twenty times as long.
TEXT
  problem examples/accuracy/crank-slider-with-friction.mech friction <<'TEXT'
Newton's method on the forces squares the error with each step: one that looks for two digits finds five, one that looks for eight
finds thirteen. The last step, to all digits, costs less than a tenth of the position; to leave it out is not worth a thought.
TEXT
  problem examples/shaper/shaper-a.mech shaper <<'TEXT'
The cutting force sets in and ends between positions, so that the torque jumps; its mean and the work of the flywheel are integrals
over pieces that end at the jumps. A piece is smooth and converges fast: with a third of the samples the integrals keep ten
digits. The jumps are found once: a root to the last digit costs some positions more than one to two digits, and no time that
could be told. A third of the time is that of following the cycle and searching it for the jumps, which no setting spares.
TEXT
  problem examples/cams/lever.mech cam <<'TEXT'
The law of a cam is evaluated, not iterated, and there is nothing to set but the scalar.
TEXT
  problem examples/general/class-iii-triad.mech class-iii <<'TEXT'
A plate on three legs has no closed form. Each step of Newton's method from the last position doubles the digits, and its certificate
tells before the step whether it is the last. All digits cost 1.4 times the position with four.
TEXT
  problem examples/general/class-iv-group.mech class-iv <<'TEXT'
Any other group is solved by the general Newton, whose setting is its last step: the error is of the order of the step's square, or
less. A last step of 1e-6 leaves nothing: the solver takes one more, a quarter of the position, to be sure of it.
TEXT
  problem examples/accuracy/chain-of-40-dyads.mech chain <<'TEXT'
Every dyad hands on what it lost to the next: of the sixteen digits of `f64` less than thirteen are left at the end of the chain,
of the seven of `f32` less than four. Here `assur solve --within 1e-15` takes double-double, and all digits of the answer are right.
TEXT
} > docs/accuracy.md
