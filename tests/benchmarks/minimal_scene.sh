#!/usr/bin/env bash
# A minimal scene by the whole program and by a program written for it alone: instructions of one evaluation, by callgrind.
#
#   tests/benchmarks/minimal_scene.sh MINIMAL_SCENE
#
# MINIMAL_SCENE is the program of minimal_scene.cpp (target minimal_scene). Counted with the baseline and the AVX2 kernel;
# callgrind knows no AVX-512. Ends with 1 where the whole program needs more than 1.1 times the instructions. Needs valgrind.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
program=$(realpath -e "$1") times=2000
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

count() {  # instruction set, function
  ADORE_ISA=$1 valgrind --tool=callgrind --callgrind-out-file="$work/counts" --collect-atstart=no \
    --toggle-collect="*$2*" "$program" $times >/dev/null 2>"$work/said" || { cat "$work/said" >&2; exit 1; }
  awk -v n=$times '/^(totals|summary):/ {printf "%.0f", $2 / n; exit}' "$work/counts"
}

over=0
printf '| kernel | whole program | minimal program | ratio |\n|---|---:|---:|---:|\n'
for set in baseline avx2; do
  whole=$(count $set full_scene) own=$(count $set minimal_scene)
  printf '| %s | %s | %s | %s |\n' $set "$whole" "$own" "$(awk "BEGIN {printf \"%.3f\", $whole / $own}")"
  awk "BEGIN {exit !($whole > 1.1 * $own)}" && over=1
done
exit $over
