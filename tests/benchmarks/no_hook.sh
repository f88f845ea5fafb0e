#!/usr/bin/env bash
# No hook, no cost: instructions of one evaluation of the right-hand side without a plug-in, with one whose routines stay
# inactive, and with routines that act, counted by callgrind.
#
#   tests/benchmarks/no_hook.sh ADORE
#
# Without a plug-in no function of user routines may run below System::rhs, and a plug-in that stays inactive may cost no more
# than what tells that there is one. ADORE_ISA=baseline, because callgrind knows no AVX-512. Needs valgrind and gcc. Ends with
# 1 where a hook costs that is not there.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
program=$(realpath -e "$1") top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export ADORE_ISA=baseline

count() {  # deck, arguments: sets `each`, and $work/functions
  local deck=$1
  shift
  rm -rf "$work/run" "$work/counts"
  valgrind --tool=callgrind --callgrind-out-file="$work/counts" --toggle-collect='*System::rhs*' -q "$program" run "$deck" "$@" \
    --set maxStps=3 --set nStps=1 --set intMet=4 --out "$work/run" --opt resultsH5=0 --quiet >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; exit 1; }
  local total calls
  total=$(sed -n 's/^\(totals\|summary\): //p' "$work/counts" | tail -1)
  calls=$(awk '/^c?fn=\([0-9]+\) adore::dynamics::System::rhs\(/ {match($0, /\([0-9]+\)/); id = substr($0, RSTART, RLENGTH)}
               /^cfn=/ {here = id != "" && index($0, id) == 5}
               /^calls=/ && here {split($1, part, "="); n += part[2]} END {print n + 0}' "$work/counts")
  [ "$calls" -gt 0 ] || { echo "no call of System::rhs was counted" >&2; exit 1; }
  each=$((total / calls))
  sed -nE 's/^c?fn=\([0-9]+\) //p' "$work/counts" | sort -u >"$work/functions"
}

mkdir "$work/idle"
cat >"$work/idle/idle.c" <<'EOF'
#include "adore_user.h"
int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
#define IDLE(name, type) int32_t name(type* a) { (void)a; return 0; }
IDLE(adrx1, adore_adrx1) IDLE(adrx2, adore_force) IDLE(adrx3, adore_force) IDLE(adrx4, adore_force) IDLE(adrx7, adore_adrx7)
IDLE(adrx9, adore_adrx9)
EOF
gcc -O2 -fPIC -shared -I"$top/core/user" -o "$work/idle/idle.so" "$work/idle/idle.c"
cp "$top/resources/decks/ball.txt" "$work/ball.txt"
{ cat "$work/ball.txt"; echo "-0.04 0.05 3 0.04"; } >"$work/asks.txt"
"$program" user new adrx7 --lang c --out "$work/adrx7" &>"$work/log"
make -s -C "$work/adrx7" CFLAGS="-O2 -fPIC" &>"$work/log"
echo '{"adrx3": {"force": "built_in"}}' >"$work/adrx3.json"

wrong=0
count "$work/ball.txt"
without=$each
if grep -E 'adore::user::|::User(Pocket|RollerPocket|Flange|Land)Block|CallRoutine|FrameForces|evaluate_user_law' "$work/functions"; then
  echo "runs though there is no plug-in"
  wrong=1
fi
printf '%-44s %10d instructions of one evaluation\n' "no plug-in" "$without"
count "$work/ball.txt" --user "$work/idle/idle.so"
printf '%-44s %10d  %+.2f %%\n' "a plug-in whose routines stay inactive" "$each" "$(awk -v a="$each" -v b="$without" 'BEGIN {print 100 * (a / b - 1)}')"
awk -v a="$each" -v b="$without" 'BEGIN {exit !(a <= 1.001 * b)}' || { echo "it costs more than a thousandth"; wrong=1; }
count "$work/asks.txt" --set kTrac=-1 --user "$work/adrx7/libadrx7.so"
printf '%-44s %10d  %+.2f %%\n' "ADRX7 in C at plain -O2" "$each" "$(awk -v a="$each" -v b="$without" 'BEGIN {print 100 * (a / b - 1)}')"
count "$work/ball.txt" --user "$work/adrx3.json"
printf '%-44s %10d  %+.2f %%\n' "ADRX3 by a formula, few contacts" "$each" "$(awk -v a="$each" -v b="$without" 'BEGIN {print 100 * (a / b - 1)}')"
exit $wrong
