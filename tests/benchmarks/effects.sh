#!/usr/bin/env bash
# What an effect costs in the right-hand side, and that it costs nothing when it is off: pairs of runs under callgrind.
#
#   tests/benchmarks/effects.sh ADORE [PATTERN]
#
# Prints for each effect the instructions of one evaluation with and without it. Ends with 1 where a block of the effect
# runs although the deck does not ask for it, or does not run although it does. ADORE_ISA=baseline, because callgrind knows
# no AVX-512. Needs valgrind. PATTERN: only effects whose name matches this extended regular expression.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
program=$(realpath -e "$1") only=${2:-.} top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export ADORE_ISA=baseline

no_slip="--set reRaceTC2=0 --set reRaceTC3=0 --set reCageTC2=0 --set reCageTC3=0 --set cageRaceTC2=0 --set cageRaceTC3=0"
no_cage="--set nCseg=0 --set kNumPltElem=2 --set kPltElemInd=1,14"
# name | deck | what turns it on | what turns it off | its blocks
pairs() {
  cat <<EOF
gravity|ball||--set gravityVecZ=0|Gravity::apply
guide lands|ball||--set nGL=0|LandBlock
cage|ball||$no_cage|PocketBlock|LandBlock|BodyMotion
friction|ball-18||$no_slip|RacePower|LandBlock<true>|PocketBlock<true
friction in pockets|ball||--set reCageTC2=0 --set reCageTC3=0|PocketBlock<true
orientation of balls|ball||--set kNumPltElem=2 --set kPltElemInd=13,15 --set kAGraf=0 --set kPrtOpt=0|OrientationMotion
turning frame|ball|--set kRotFrame=1 --set brgAngVel=200||Fields
rotating load|ball|--set kVarLoad=1 --set rotLoadFrac2=0.5 --set rotLoadRpm2=10000||RacePlaces
ramp of speed|ball|--set kVarSpeed=1 --set raceAngAcc2=1e3 --set endTime2=1||RaceTurns
free race|ball|--set kDCR=1 --set kFD12=0||RaceKinematics|RaceLoad|HeldDirections
light balls in balance|ball|--set appLoadX=200 --set appLoadZ=2000 --set qFac=0.1|--set appLoadX=200 --set appLoadZ=2000|HeldRates|HeldMotion
contact angle that moves|ball||--opt hertzConstants=frozen|-
contact damping: ball|ball||--opt contactDamping=0|-
contact damping: ball-18|ball-18||--opt contactDamping=0|-
contact damping: cylindrical|cylindrical||--opt contactDamping=0|-
contact damping: tapered|tapered||--opt contactDamping=0|-
contact damping: spherical|spherical||--opt contactDamping=0|-
oil: film and rolling resistance|ball|--set kTrac=3 --set reRaceFilm=1e-8 --set strParam=10||BallRolling
suppressed motions|ball|--set kDOF=2||Hold
balls of unequal diameter|ball|--set kReGeoImp=2 --set reDiaVar1=1e-6||DifferentBalls|UnequalBallMotion
flanges|cylindrical||--set kFlngInd11=0 --set kFlngInd12=0 --set kFlngInd21=0 --set kFlngInd22=0|FlangeBlock
cage of rollers|cylindrical||--set nCseg=0 --set kNumPltElem=2 --set kPltElemInd=1,16|RollerPocketBlock|LandBlock
EOF
}

# Sets `each` (instructions of one evaluation) and $work/functions.
count() {  # deck, arguments
  rm -rf "$work/run" "$work/out"
  # shellcheck disable=SC2086
  valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='*System::rhs*' -q "$program" run \
    "$top/resources/decks/$1.txt" $2 --set maxStps=3 --set nStps=1 --set intMet=4 --out "$work/run" --opt resultsH5=0 --quiet \
    >"$work/log" 2>&1 || { cat "$work/log" >&2; return 1; }
  local total calls
  total=$(sed -n 's/^\(totals\|summary\): //p' "$work/out" | tail -1)
  calls=$(awk '/^c?fn=\([0-9]+\) adore::dynamics::System::rhs\(/ {match($0, /\([0-9]+\)/); id = substr($0, RSTART, RLENGTH)}
               /^cfn=/ {here = id != "" && index($0, id) == 5}
               /^calls=/ && here {split($1, part, "="); n += part[2]} END {print n + 0}' "$work/out")
  [ "$calls" -gt 0 ] || { echo "no call of System::rhs was counted" >&2; return 1; }
  each=$((total / calls))
  sed -nE 's/^c?fn=\([0-9]+\) //p' "$work/out" | sort -u >"$work/functions"
}

wrong=0
printf '%-28s %12s %12s %8s\n' effect with without share
while IFS='|' read -r name deck on off blocks; do
  [[ $name =~ $only ]] || continue
  count "$deck" "$on" || { echo "$name: the run with it failed"; wrong=1; continue; }
  with=$each
  [ "$blocks" = - ] || grep -qE "$blocks" "$work/functions" || { echo "$name: no block of it runs though it is on"; wrong=1; }
  count "$deck" "$off" || { echo "$name: the run without it failed"; wrong=1; continue; }
  without=$each
  [ "$blocks" = - ] || ! grep -qE "$blocks" "$work/functions" || { echo "$name: runs though it is off: $(grep -E "$blocks" "$work/functions" | head -1)"; wrong=1; }
  # The limit that was set for it (decision 001).
  [ "$name" != "contact angle that moves" ] || [ $((10 * (with - without))) -le "$without" ] ||
    { echo "$name: more than 10 % slower than frozen constants"; wrong=1; }
  # At most a tenth more, in the code of the contacts (decision 800).
  [[ "$name" != "contact damping: "* ]] || [ $((10 * (with - without))) -le "$without" ] ||
    { echo "$name: more than a tenth more instructions than elastic contacts"; wrong=1; }
  awk -v n="$name" -v a="$with" -v b="$without" 'BEGIN {printf "%-28s %12d %12d %7.1f%%\n", n, a, b, 100 * (a - b) / a}'
done < <(pairs)
exit $wrong
