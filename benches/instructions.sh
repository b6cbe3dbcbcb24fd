#!/bin/sh
# Instructions per position of the loop over positions, counted by valgrind: Andrews' mechanism asking for one thing, once as
# bare as it can be and once with effects declared that this does not call for. Prints a table for docs/measured/effects.md.
#
#     benches/instructions.sh
set -eu
cd "$(dirname "$0")/.."
program=$(cargo bench --no-run --bench position --message-format json | sed -n 's/.*"executable":"\([^"]*position-[^"]*\)".*/\1/p')
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The machine with 36 positions; what the options name is left out or put in.
scene() {
    speed=$1 masses=$2 acts=$3 rough=$4 find=$5
    sed '/^find/,$d; s/in 12 steps/in 36 steps/' examples/kinetostatics/andrews.mech > "$folder/scene"
    [ "$speed" = still ] && sed -i 's/ in 36 steps at omega1/ in 36 steps/' "$folder/scene"
    [ "$masses" = light ] && sed -i 's/; mass [^}]*}/ }/' "$folder/scene"
    [ "$rough" = rough ] && sed -i 's/^revolute .*/& { friction_circle 0.1 mm }/' "$folder/scene"
    case $acts in
    nothing) sed -i '/^spring/d; /^torque/d' "$folder/scene" ;;
    torque) sed -i '/^spring/d' "$folder/scene" ;;
    weightless) sed -i '/^spring/d; s/^torque/gravity 9.81 m\/s^2\n&/' "$folder/scene" ;;
    all)
        cat >> "$folder/scene" <<'END'
gravity 9.81 m/s^2
force P on AH at H = (3 N, 1 N)
torque M on AG = 0.01 N*m cw when angle(OF) > 90 deg
END
        ;;
    esac
    printf 'find %s\n' "$find" >> "$folder/scene"
}

# Instructions of so many rounds.
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$folder/scene" --rounds "$1" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}

per_position() {
    scene "$@"
    few=$(count 10)
    many=$(count 110)
    echo $(((many - few) / 3600))
}

row() {
    asked=$1 declared=$2 bare=$3 with=$4
    printf '| %s | %s | %s | %s | %s |\n' "$asked" "$declared" "$bare" "$with" \
        "$(awk "BEGIN { printf \"%+.1f %%\", 100 * ($with / $bare - 1) }")"
}

echo '| asked for | declared beside it | without | with | difference |'
echo '| --- | --- | --- | --- | --- |'
all='masses, weights, spring, loads, friction'
row 'positions' "a speed, $all" \
    "$(per_position still light nothing smooth 'position(AH.H)')" "$(per_position speed heavy all rough 'position(AH.H)')"
row 'velocities' "$all" \
    "$(per_position speed light nothing smooth 'velocity(AH.H)')" "$(per_position speed heavy all rough 'velocity(AH.H)')"
row 'accelerations' "$all" \
    "$(per_position speed light nothing smooth 'acceleration(AH.H)')" "$(per_position speed heavy all rough 'acceleration(AH.H)')"
static=$(per_position still light torque smooth 'Mb, reactions')
row 'reactions at rest' 'masses' "$static" "$(per_position still heavy torque smooth 'Mb, reactions')"
row 'reactions at rest' 'weights without masses' "$static" "$(per_position still light weightless smooth 'Mb, reactions')"
row 'reactions at rest' 'friction' "$static" "$(per_position still light torque rough 'Mb, reactions')"
