#!/usr/bin/env bash
# The C examples of `adore user new` under AddressSanitizer and UndefinedBehaviorSanitizer: what the program hands to
# plug-ins is as long as it says, and no plug-in reads or writes beyond.
#
#   tests/library/user_sanitized.sh ADORE
#
# Every example is built with the sanitizers by its own makefile and takes part in a short run, the sanitizer's library loaded
# before the program, so that the program's arrays have fences. A plug-in that writes behind its last array must be caught, or
# the net has holes. Ends with 77 where gcc has no sanitizer.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
library=$(gcc -print-file-name=libasan.so) || library=
[ -e "$library" ] || { echo "skipped: gcc has no libasan here"; exit 77; }
program=$(realpath -e "$1") top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

build() {  # hook, folder
  "$program" user new "$1" --lang c --out "$2" &>"$work/log" || { cat "$work/log"; exit 1; }
}
make_it() {
  make -s -C "$1" CFLAGS="-O1 -g -fPIC -fsanitize=address,undefined -fno-sanitize-recover=undefined" LDFLAGS= &>"$work/log" ||
    { cat "$work/log"; exit 1; }
}
run_it() {  # deck, plug-in, arguments
  local deck=$1 plug_in=$2
  shift 2
  LD_PRELOAD="$library:$(gcc -print-file-name=libubsan.so)" ASAN_OPTIONS=detect_leaks=0 "$program" run "$deck" --user "$plug_in" "$@" \
    --set maxStps=1000 --until 2e-5s --set kAGraf=0 --opt resultsH5=0 --quiet --out "$work/out" --overwrite &>"$work/log"
}

wrong=0
while IFS='|' read -r hook deck lines arguments; do
  if [ ! -e "$work/$hook" ]; then
    build "$hook" "$work/$hook"
    make_it "$work/$hook"
  fi
  { cat "$top/resources/decks/$deck.txt"; [ -z "$lines" ] || echo "${lines//;/$'\n'}"; } >"$work/deck.txt"
  # shellcheck disable=SC2086
  if run_it "$work/deck.txt" "$work/$hook/lib$hook.so" $arguments && ! grep -qE "Sanitizer|runtime error" "$work/log"; then
    echo "$hook on $deck: clean"
  else
    echo "$hook on $deck: not clean"
    cat "$work/log"
    wrong=1
  fi
done <<'EOF'
adrx0|ball||--set kReMat=2
adrx1|ball|0 1e-5 10000 10100;0 0|
adrx2|tapered|1e-9|
adrx3|ball|1e-9|--set avRatio=1.2
adrx3|cylindrical|1e-9|--set avRatio=1.2
adrx4|cylindrical|1e-9|--set cageGsCls[1]=1e-8
adrx5|cylindrical|0.008 2.0|--set bReCrn=1e10
adrx6|ball|1e-6 9 0.3|--set kRaceGeoImp2=3
adrx7|ball|-0.04 0.05 3 0.04|--set kTrac=-1
adrx8|ball|1e-7|--set kReGeoImp=3
adrx9|ball||
EOF

# The net: numbers behind the last are written, where several contacts are asked at once. The program keeps the arrays of one
# contact on its stack, which has no fences.
build adrx7 "$work/beyond"
sed -i 's/const int64_t n = a->points \* a->stride;/const int64_t n = a->points * a->stride + (a->points > 1 ? 4096 : 0);/' "$work/beyond/adrx7.c"
make_it "$work/beyond"
{ cat "$top/resources/decks/ball.txt"; echo "-0.04 0.05 3 0.04"; } >"$work/deck.txt"
if run_it "$work/deck.txt" "$work/beyond/libadrx7.so" --set kTrac=-1; then
  echo "a plug-in that writes behind its arrays was not caught"
  wrong=1
else
  grep -qE "heap-buffer-overflow|AddressSanitizer" "$work/log" || { echo "caught, but not by the sanitizer:"; cat "$work/log"; wrong=1; }
  echo "a plug-in that writes behind its arrays: caught"
fi
exit $wrong
