#!/usr/bin/env bash
# What a C routine ADRX7 costs that restates the built-in traction of races: whole runs, user time.
#
#   tests/benchmarks/user_routine.sh ADORE [PAIRS [UNTIL [ball | cylindrical]]]
#
# Writes and builds the example of `adore user new adrx7` with the flags of its makefile, then runs the example deck PAIRS
# times (7) until UNTIL (2e-2s) with the built-in law and with the routine in turn. Prints both times, the smallest of
# each, their ratio and the same with plain -O2. Ends with 1 where the ratio is above 1.3 (above 3 with -O2). Needs gcc.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2; }
program=$(realpath -e "$1") pairs=${2:-7} until=${3:-2e-2s} type=${4:-ball} top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$program" user new adrx7 --lang c --out "$work/fast" &>"$work/log"
cp -r "$work/fast" "$work/plain"
make -s -C "$work/fast" >/dev/null
make -s -C "$work/plain" CFLAGS="-O2 -fPIC" >/dev/null

# Record 10.1C of the deck (type 1: 0, 0.06, 0.04, 0.5) as A, B, C, D: (1 - x) exp(x) = A/M, C = x/0.5.
awk 'BEGIN {A = -0.04; M = 0.02; low = 1; high = 3
            for (i = 0; i < 200; ++i) {x = (low + high) / 2; if ((1 - x) * exp(x) > A / M) low = x; else high = x}
            printf "%.17g %.17g %.17g %.17g\n", A, x / 0.5 * M * exp(x), x / 0.5, 0.04}' >"$work/lines"
cat "$top/resources/decks/$type.txt" "$work/lines" >"$work/asks.txt"

one() {  # name, deck, arguments: user time of one run
  local name=$1 deck=$2
  shift 2
  rm -rf "$work/out"
  TIMEFORMAT=%U
  { time "$program" run "$deck" "$@" --set maxStps=1000000 --until "$until" --set kAGraf=0 --out "$work/out" \
      --opt resultsH5=0 --quiet >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }; } 2>>"$work/time-$name"
  sed -n 's/.*"evaluations": \([0-9]*\).*/\1/p' "$work/out/RUN.json" | head -1 >"$work/evaluations"
}
for ((k = 0; k < pairs; ++k)); do
  one built-in "$top/resources/decks/$type.txt"
  one fast "$work/asks.txt" --set kTrac=-1 --user "$work/fast/libadrx7.so"
  one plain "$work/asks.txt" --set kTrac=-1 --user "$work/plain/libadrx7.so"
done
paste "$work/time-built-in" "$work/time-fast" "$work/time-plain" | awk 'BEGIN {print "built-in  routine  routine -O2   user time of each run [s]"}
  {printf "%8.2f %8.2f %8.2f\n", $1, $2, $3}'
least() { sort -g "$work/time-$1" | head -1; }
awk -v b="$(least built-in)" -v f="$(least fast)" -v p="$(least plain)" -v n="$(cat "$work/evaluations")" 'BEGIN {
  printf "least: built-in %.2f s, routine %.2f s (%.2f times), with plain -O2 %.2f s (%.2f times); %d evaluations\n", b, f, f / b, p, p / b, n
  exit !(f <= 1.3 * b && p <= 3 * b)}'
