#!/usr/bin/env bash
# What each omission saves in instructions: prints the table of README.md. Needs valgrind.
# A row: how many per cent more instructions a process executes that does not make the omission.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --release --quiet -p catoptric-benches --bin picture -p catoptric-cli
target=${CARGO_TARGET_DIR:-target}/release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Scenes that are changes of others, so that each omission has two to save on.
sed 's/^\(specular\|diffuse\) = .*/\1 = 0/' scenes/kissing.toml >"$work/kissing-mirrors.toml"
awk '/^\[/ { mirror = $0 == "[materials.mirror]" }
    mirror && /^(specular|diffuse) =/ { $0 = $1 " = 0" } 1' scenes/corridor.toml \
    >"$work/corridor-mirrors.toml"
sed 's/^specular = .*/specular = 0/; s/^reflect = .*/reflect = 0/' scenes/workshop.toml \
    >"$work/workshop-plain.toml"
"$target/catoptric" generate sphereflake --levels 2 -o "$work/sphereflake.toml" --quiet

# A ball of half the size in each ball.
cores() {
    awk '{ print } /^center/ { center = $0 } /^radius/ && $3 < 1000 {
        inner = inner "\n[[spheres]]\n" center "\nradius = " $3 / 2 "\ncolor = [1, 1, 1]\n" }
        END { print inner }' "$1"
}
cores scenes/workshop.toml >"$work/workshop-cores.toml"
cores scenes/kissing.toml >"$work/kissing-cores.toml"

instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$target/picture" "$@" 2>&1 |
        sed -n 's/.*refs: *//p' | tr -d ,
}
echo '| scene | nested | tiles | occluders | directions | shadows | all |'
echo '|---|---|---|---|---|---|---|'
row() {
    local name=$1 plan
    shift
    plan=$(instructions "$@" plan)
    printf '| %s, %sx%s, depth %s |' "$name" "$2" "$3" "$4"
    for without in nested tiles occluders directions shadows everything; do
        awk -v a="$(instructions "$@" "$without")" -v b="$plan" \
            'BEGIN { printf " %.1f |", 100 * (a / b - 1) }'
    done
    echo
}
row 'workshop' scenes/workshop.toml 960 540 5
row 'workshop without mirrors and highlights' "$work/workshop-plain.toml" 960 540 5
row 'workshop, a ball in each ball' "$work/workshop-cores.toml" 960 540 5
row 'kissing, a ball in each ball' "$work/kissing-cores.toml" 320 180 8
row 'sphereflake of 91 balls' "$work/sphereflake.toml" 320 180 5
row 'corridor' scenes/corridor.toml 320 180 16
row 'corridor, its mirrors without light of their own' "$work/corridor-mirrors.toml" 320 180 16
row 'kissing' scenes/kissing.toml 320 180 8
row 'kissing, mirrors without light of their own' "$work/kissing-mirrors.toml" 320 180 8
row 'planes' scenes/planes.toml 320 180 8
row 'coloured lights' scenes/coloured-lights.toml 320 180 8
row 'closed room' scenes/closed-room.toml 160 90 16
