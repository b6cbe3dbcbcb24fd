#!/usr/bin/env bash
# Writes docs/measured/simulation.md and its diagrams. The times are those of this machine. The comparison with other programs stays as
# it was, unless PEERS=1 has benches/simulate/run.py write it anew.
set -euo pipefail
cd "$(dirname "$0")/../.."
# ASSUR names a program that is built already
if [ -z "${ASSUR:-}" ]; then
  cargo build --release --quiet
fi
assur=${ASSUR:-target/release/assur}
mkdir -p docs/measured/simulation
page=docs/measured/simulation.md
kept=$(mktemp)
sed -n '/^<!-- peers: /,/^<!-- end of peers -->$/p' "$page" > "$kept" 2>/dev/null || true

# motion NAME: the comment comes on standard input.
motion() {
  local file=examples/simulation/$1.mech
  "$assur" accuracy "$file" --plot "docs/measured/simulation/$1.svg" > "docs/measured/simulation/$1.part"
  echo
  sed -n '1s/^\(.*\) (.*)\(: what accuracy costs\)$/## \1/p' "docs/measured/simulation/$1.part"
  echo
  cat
  echo
  echo "![error against time](simulation/$1.svg)"
  echo
  echo '```text'
  cat "docs/measured/simulation/$1.part"
  echo '```'
  rm "docs/measured/simulation/$1.part"
}

{
  cat <<'TEXT'
# What accuracy costs in a motion under loads

![error against time of Andrews' mechanism by three methods](simulation/andrews.svg)

Twelve digits take little longer than eight. By the method that `solve` chooses, a further digit takes some tenth more time, by DOP853 a fifth to a half.
Radau IIA, which is for stiff motions, stops near ten digits. This page is for developers; [../simulation.md](../simulation.md) is for users.

Written by

```sh
docs/measured/simulation.sh
```

from what `assur accuracy FILE` prints; `--details` has the tables of every accuracy and method, and [commands.md](../commands.md#accuracy) explains the errors and their
reference. The times are those of one machine; on another machine their ratios change little. A time is that of the printed run and of those that estimate its error,
as evaluations times their price. It does not include reading the text, the answers at the printed instants, and writing them.

Common results:

- The reported error is 1 to 30 times the true error in 95 of 100 runs over all examples, and never below a third of it. By DOP853 and
  Radau IIA the printed run has half the steps of the run before, or two thirds for few digits. So it is often far better than wanted.
- If one coordinate decides all forces, as in Andrews' mechanism, the motion follows from the energy. Mass and force along the coordinate are evaluated only for
  new values of the coordinate. For the same error this takes a sixth to a twentieth of the evaluations of DOP853, which is the curve below.
- Ten times the accuracy takes DOP853, a method of order 8, about a third more steps. From 1e-6 to 1e-12 the time grows about fivefold. A third of it or
  more is for runs that only estimate the error, or are too coarse.
- Radau IIA is of order 5: it takes more steps from the first digits on, and stops near 1e-10, because the differences in its matrix have no
  more digits. It is for stiff motions, such as the flap in oil, which DOP853 would follow in millions of steps.
- Below about 1e-13 only rounding remains: a finer tolerance takes more steps, gives no digit, and the run reports this.
TEXT
  motion andrews <<'TEXT'
One free coordinate, three dyads, a spring; the standard test problem. All kinds of results are compared; the angular accelerations have the largest errors.
TEXT
  motion engine-run-up <<'TEXT'
A motor line of two straight pieces: a step ends at its corner.
TEXT
  motion five-bar <<'TEXT'
Two free coordinates.
TEXT
  motion double-pendulum <<'TEXT'
Two free coordinates in a chaotic motion: an early error grows until the end.
TEXT
  motion pulled-block <<'TEXT'
Stick and slip: while the block may start at any time, the steps have a greatest length at any accuracy. Within them the motion is a sine, which
DOP853 follows to rounding.
TEXT
  motion rough-double-pendulum <<'TEXT'
Two free coordinates with friction in both hinges, which come to rest and slide again independently. The reference is a run at the finest tolerance.
TEXT
  motion engine-with-friction <<'TEXT'
Friction in all four pairs of an engine: accelerations are found with the forces, and steps end where a pair slides the other way. The reference is a run
at the finest tolerance.
TEXT
  motion flap-in-oil <<'TEXT'
Rates of 0.4 and 5,000,000 in a second. DOP853 finds that stability limits its steps, and changes to Radau IIA.
TEXT
  cat <<'TEXT'

## What others need

Written by `python3 benches/simulate/run.py --write`, which installs the other programs under target/simulate-peers, and tries several tolerances or steps in
each: the fastest that keeps an error is shown. Errors are against references with 30 digits, at the last instant: of Andrews' mechanism
the greatest |Δq|/(1 + |q|) of its angles. A run is the motion alone, without reading the text; that of assur has the runs from which its error is estimated, and its evaluations are those of the run that is printed. `assur` uses the energy method here. For the rows "DOP853" the file has a
load that depends on time, of 1e-30 N m/s. It switches the energy method off. A process begins with
starting the interpreter, and with compiling by numba or the C compiler. The times of the others are those on the processor, the least of several; of RADAU5, whose clock
has milliseconds, the mean. The equations for RADAU5, scipy and IDA are those of the angles of all links: compiled by the C compiler for RADAU5, which is called
without a line of R between, and by numba for scipy and IDA; what calls them there is Python.

In the table of four-bars a run of assur is its process less that of `assur check`, for an accuracy of 1e-8. With general
equations the other programs leave the solution at the first dead position, at any tolerance. RADAU5 and scipy are shown for one four-bar; IDA does
not end within a minute there.
TEXT
  echo
  if [ -s "$kept" ]; then cat "$kept"; else printf '%s\n%s\n' '<!-- peers: written by benches/simulate/run.py -->' '<!-- end of peers -->'; fi
} > "$page.new"
mv "$page.new" "$page"
rm "$kept"
if [ -n "${PEERS:-}" ]; then
  python3 benches/simulate/run.py --write
fi
