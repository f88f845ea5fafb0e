#!/usr/bin/env bash
# The examples of `adore user new` in C, C++, Fortran and Python give the same trajectory; the compiled ones are built by their
# own makefiles.
#
#   [PYTHON=python3] tests/library/user_languages.sh ADORE
#
# ADRX1 (a race that spins up, a housing that shakes), ADRX7 (traction of races) and ADRX9 (a map of the heat), some 0.1 ms of the
# ball deck each: FINAL, and SOL9 of ADRX9, must have the same numbers in all languages to 1e-6 of their size. Python takes part
# where PYTHON imports the module. The coefficients of its ADRX7 stand in the program, so that its deck has no line behind it; the
# function itself is held to 1e-6, and its table, within 1e-7 of the law, to 2e-5 but for the size of the next step.
# Ends with 77 where there is no gfortran.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
command -v gfortran >/dev/null || { echo "skipped: there is no gfortran on this machine"; exit 77; }
program=$(realpath -e "$1") top=$(cd "$(dirname "$0")/../.." && pwd) python=${PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
languages="c cpp fortran"
if "$python" -c 'import adore' &>/dev/null; then languages+=" python"; else echo "without Python: $python has no module adore"; fi

quietly() { "$@" &>"$work/log" || { cat "$work/log"; exit 1; }; }

run_in() {  # hook, language
  local folder=$work/$1-$2
  quietly "$program" user new "$1" --lang "$2" --out "$folder"
  if [ "$2" = python ]; then
    quietly "$python" "$folder/$1.py" "$work/$1.txt" "$folder/out"
  else
    quietly make -s -C "$folder"
    quietly "$program" run "$work/$1.txt" --quiet --user "$folder/lib$1.so" --out "$folder/out"
  fi
}

# Numbers of a file of C and of another language by line and column.
compare() {  # hook, language, file, [bound]
  awk -v what="$1 $3, c and $2" -v bound="${4:-1e-6}" '
    function number(word) {return word ~ /^[-+]?[0-9]*\.?[0-9]+([eEdD][-+]?[0-9]+)?$/}
    NR == FNR {for (k = 1; k <= NF; ++k) first[FNR, k] = $k; lines = FNR; next}
    {for (k = 1; k <= NF; ++k)
       if (number($k) && number(first[FNR, k])) {
         a = first[FNR, k] + 0; b = $k + 0; ++numbers
         size = a < 0 ? -a : a; off = a > b ? a - b : b - a
         if (off > 0) ++differ
         if (size > 1e-9 && off / size > worst) {worst = off / size; at = FNR}
       }}
    END {printf "%s: %d numbers, %d differ, at most by %.2g of their size (line %d)\n", what, numbers, differ, worst, at
         exit !(FNR == lines && numbers > 100 && worst < bound)}' "$work/$1-c/out/$3" "$work/$1-$2/out/$3"
}

python_traction() {
  local folder=$work/adrx7-python
  quietly "$program" user new adrx7 --lang python --out "$folder"
  quietly "$python" "$folder/adrx7.py" "$work/bare.txt" "$folder/table"
  sed -i -e 's/table=True, //' -e 's/def traction(slip)/def traction(slip, contacts)/' "$folder/adrx7.py"
  quietly "$python" "$folder/adrx7.py" "$work/bare.txt" "$folder/out"
  compare adrx7 python FINAL
  mkdir -p "$work/adrx7-table"
  cp -r "$folder/table" "$work/adrx7-table/out"
  sed -i '/^step_size/d' "$work/adrx7-table/out/FINAL" "$work/adrx7-c/out/FINAL"
  compare adrx7 table FINAL 2e-5
}

# Ends after 13 time scales; SOL8 is not stored.
sed -e "s/3600\.0/13.0/" -e "/Rec 1'/s/250, 1, 5,/250, 1, 0,/" "$top/resources/decks/ball.txt" >"$work/adrx9.txt"
{ cat "$work/adrx9.txt"; echo "2e-5 6e-5 10000 10300"; echo "2e-6 2000"; } >"$work/adrx1.txt"
sed "s/'Rec 10.0', 0, 1,/'Rec 10.0', -1, 1,/" "$work/adrx9.txt" >"$work/bare.txt"
{ cat "$work/bare.txt"; echo "-0.04 0.05 3 0.04"; } >"$work/adrx7.txt"
for hook in adrx1 adrx7 adrx9; do
  for language in $languages; do
    if [ "$hook $language" = "adrx7 python" ]; then
      python_traction
      continue
    fi
    run_in "$hook" "$language"
    [ "$language" = c ] && continue
    compare "$hook" "$language" FINAL
    if [ "$hook" = adrx9 ]; then compare "$hook" "$language" SOL9; fi
  done
done
