#!/usr/bin/env bash
# Runs the libFuzzer targets on the stable toolchain.
#
#   fuzz/run.sh [INPUTS [SECONDS [TARGET…]]]
#
# At most INPUTS inputs (100000) and SECONDS seconds (600) for each target (parse, solve, draw, runs, messages). An input that panics, takes
# longer than 2 s or more than 1 GB ends its target; it stays in fuzz/artifacts. The last lines are the figures.
set -euo pipefail
cd "$(dirname "$0")/.."

inputs=${1:-100000}
seconds=${2:-600}
shift $(($# < 2 ? $# : 2))
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(parse solve draw runs messages)

if ! command -v c++ >/dev/null; then
  echo "libFuzzer is written in C++: a compiler is installed" >&2
  if [ "$(id -u)" = 0 ]; then apt-get install -y g++; else sudo apt-get install -y g++; fi
fi

# Coverage alone: address sanitizing takes a nightly compiler, and the crates have no unsafe code. Without tracing of
# compares, which took more time than the program: the seeds hold every word of the language.
flags=(
  -Cpasses=sancov-module
  -Cllvm-args=-sanitizer-coverage-level=4
  -Cllvm-args=-sanitizer-coverage-inline-8bit-counters
  -Cllvm-args=-sanitizer-coverage-pc-table
  --cfg=fuzzing
)
host=$(rustc -vV | sed -n 's/^host: //p')
# with --target the flags reach neither build scripts nor macros
RUSTFLAGS="${flags[*]}" cargo build --release --manifest-path fuzz/Cargo.toml --target "$host" --bins

# Every statement of the examples and of the tests by itself, and the shorter files whole: most slips lie in one line, and a
# line is read twenty times as fast as a file.
seeds=fuzz/corpus/seeds
rm -rf "$seeds"
mkdir -p "$seeds" fuzz/artifacts fuzz/logs
find examples tests -name '*.mech' -size -3k | while read -r file; do
  cp "$file" "$seeds/$(echo "$file" | tr / _)"
done
find examples tests -name '*.mech' -exec cat {} + | sed 's/^ *//' | grep -avE '^(//|$)' | awk 'length < 100' | sort -u |
  split -a 4 -l 1 - "$seeds/line-"

# Lines of `parse` stay lines; the others need files.
longest() { if [ "$1" = parse ]; then echo 100; else echo 2000; fi; }

status=0
figures="target  inputs  per second  peak MB  slowest s  result"
for target in "${targets[@]}"; do
  mkdir -p "fuzz/corpus/$target"
  log=fuzz/logs/$target.log
  result=fine
  # without weights for rare branches, which took more time than the program
  "fuzz/target/$host/release/$target" -runs="$inputs" -max_total_time="$seconds" -timeout=2 -rss_limit_mb=1024 \
    -entropic=0 -max_len="$(longest "$target")" -print_final_stats=1 -artifact_prefix="fuzz/artifacts/$target-" \
    "fuzz/corpus/$target" "$seeds" >"$log" 2>&1 || { result="stopped, see $log"; status=1; }
  stat() { sed -n "s/^stat::$1: *//p" "$log" | tail -1; }
  figures+=$'\n'"$target  $(stat number_of_executed_units)  $(stat average_exec_per_sec)  $(stat peak_rss_mb)  $(stat slowest_unit_time_sec)  $result"
done
echo "$figures" | awk -F '  ' '{ printf "%-7s %10s %12s %9s %11s  %s\n", $1, $2, $3, $4, $5, $6 }'
exit $status
