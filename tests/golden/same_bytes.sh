#!/usr/bin/env bash
# same_bytes.sh TOOLPACE OTHER: plans every example with both programs, in three ways, and compares setpoints and JSON. OTHER may be
# a command of more words, such as "wine toolpace.exe".
set -euo pipefail
cd "$(dirname "$0")/../.."
one=$1 other=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# plan PROGRAM OUT FLAGS…: its JSON without the one figure that no two runs share
plan() {
  local program=$1 out=$2
  shift 2
  $program plan "$@" --setpoints "$out" --json | grep -v plan_wall_s
}

ways=("" "--law seven-phase --ramps span" "--law seven-phase --ramps span --corner blend --tolerance-mm 0.02")
compared=0 different=0
for file in examples/nc/*; do
  for way in "${ways[@]}"; do
    # shellcheck disable=SC2086
    plan "$one" "$scratch/a.npy" "$file" $way >"$scratch/a.json" && plan "$other" "$scratch/b.npy" "$file" $way >"$scratch/b.json"
    compared=$((compared + 1))
    if ! cmp -s "$scratch/a.npy" "$scratch/b.npy" || ! cmp -s "$scratch/a.json" "$scratch/b.json"; then
      echo "different: $file $way"
      different=$((different + 1))
    fi
  done
done
echo "$compared plans compared, $different different"
[ "$different" -eq 0 ]
