#!/usr/bin/env bash
# What is too long for each change: the whole suite of the release build with the configuration "nightly", option pairs, random decks,
# hard scenes and fuzzers under ASan and UBSan, studies, sweeps and threads of the apps under TSan.
#
#   tests/nightly.sh [release|asan|tsan]...     all three without a word; hours
#
# Logs: build/PRESET/Testing/Temporary/LastTest.log. Exit code 1 when a preset fails; the others run all the same.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 QT_QPA_PLATFORM=offscreen
failed=()
for part in "${@:-release asan tsan}"; do
  for name in $part; do
    case $name in
      release) configure=release test=nightly ;;
      asan) configure=nightly-asan test=nightly-asan ;;
      tsan) configure=nightly-tsan test=nightly-tsan ;;
      *) echo "nightly.sh: there is no part '$name'; give release, asan or tsan" >&2; exit 2 ;;
    esac
    { cmake --preset "$configure" && cmake --build --preset "$configure" && ctest --preset "$test"; } || failed+=("$name")
  done
done
[ ${#failed[@]} -eq 0 ] || { echo "nightly: failed: ${failed[*]}" >&2; exit 1; }
echo "nightly: all parts passed"
