#!/usr/bin/env bash
# Instructions of one evaluation of the right-hand side, counted by callgrind on three decks.
#
#   tests/gate/instructions.sh ADORE [ADORE...]
#
# Prints for each program and deck: evaluations of the run and instructions per evaluation, everything below System::rhs.
# A change of structure may cost at most 3 %. ADORE_ISA=baseline, because callgrind knows no AVX-512.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export ADORE_ISA=baseline
for program in "$@"; do
  rm -rf "${work:?}"/*
  for deck in "ball-18|" "ball-thrust|" "ball|--set appLoadX=200 --set appLoadZ=2000 --set qFac=0.1"; do
    name=${deck%%|*} arguments=${deck#*|}
    # shellcheck disable=SC2086
    valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='*System::rhs*' -q \
      "$program" run "$top/resources/decks/$name.txt" $arguments --set maxStps=6 --set nStps=1 --set intMet=4 --out "$work/$name" \
      --opt resultsH5=0 --quiet >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    total=$(sed -n 's/^\(totals\|summary\): //p' "$work/out" | tail -1)
    # callgrind writes a name once and its number after that: "cfn=(12) name", then "cfn=(12)", each before "calls=N ...".
    calls=$(awk '/^c?fn=\([0-9]+\) adore::dynamics::System::rhs\(/ {match($0, /\([0-9]+\)/); id = substr($0, RSTART, RLENGTH)}
                 /^cfn=/ {here = id != "" && index($0, id) == 5}
                 /^calls=/ && here {split($1, part, "="); n += part[2]} END {print n + 0}' "$work/out")
    [ "$calls" -gt 0 ] || { echo "no call of System::rhs was counted" >&2; exit 1; }
    echo "$program $name${arguments:+ (qFac)}: $calls evaluations, $((total / calls)) instructions each"
  done
done
