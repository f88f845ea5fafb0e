#!/usr/bin/env bash
# The examples of `adore user new` in C and in Fortran give the same trajectory, built by their own makefiles.
#
#   tests/library/user_languages.sh ADORE
#
# ADRX1 (a race that spins up, a housing that shakes) and ADRX7 (traction of races), 0.1 ms of the ball deck each: FINAL of
# both languages must have the same numbers to 1e-6 of their size. Ends with 77 where there is no gfortran.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
command -v gfortran >/dev/null || { echo "skipped: there is no gfortran on this machine"; exit 77; }
program=$(realpath -e "$1") top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run_with() {  # hook, language, arguments
  local hook=$1 lang=$2
  shift 2
  "$program" user new "$hook" --lang "$lang" --out "$work/$hook-$lang" &>"$work/log" || { cat "$work/log"; exit 1; }
  make -s -C "$work/$hook-$lang" &>"$work/log" || { cat "$work/log"; exit 1; }
  "$program" run "$work/$hook.txt" "$@" --set maxStps=1000000 --until 1e-4s --set kAGraf=0 --opt resultsH5=0 --quiet \
    --user "$work/$hook-$lang/lib$hook.so" --out "$work/$hook-$lang/out" &>"$work/log" || { cat "$work/log"; exit 1; }
}

# Numbers of FINAL by line and column.
compare() {  # hook
  awk -v hook="$1" '
    function number(word) {return word ~ /^[-+]?[0-9]*\.?[0-9]+([eEdD][-+]?[0-9]+)?$/}
    NR == FNR {for (k = 1; k <= NF; ++k) first[FNR, k] = $k; lines = FNR; next}
    {for (k = 1; k <= NF; ++k)
       if (number($k) && number(first[FNR, k])) {
         a = first[FNR, k] + 0; b = $k + 0; ++numbers
         size = a < 0 ? -a : a; off = a > b ? a - b : b - a
         if (off > 0) ++differ
         if (size > 1e-9 && off / size > worst) {worst = off / size; at = FNR}
       }}
    END {printf "%s: %d numbers, %d differ, at most by %.2g of their size (line %d)\n", hook, numbers, differ, worst, at
         exit !(FNR == lines && numbers > 100 && worst < 1e-6)}' "$work/$1-c/out/FINAL" "$work/$1-fortran/out/FINAL"
}

{ cat "$top/resources/decks/ball.txt"; echo "2e-5 6e-5 10000 10300"; echo "2e-6 2000"; } >"$work/adrx1.txt"
{ cat "$top/resources/decks/ball.txt"; echo "-0.04 0.05 3 0.04"; } >"$work/adrx7.txt"
for lang in c fortran; do
  run_with adrx1 "$lang"
  run_with adrx7 "$lang" --set kTrac=-1
done
compare adrx1
compare adrx7
