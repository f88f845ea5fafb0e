#!/usr/bin/env bash
# Runs ./run.sh, checks the formatting, then runs the reference cases, the readers and fuzzers under sanitizers and every test.
set -euo pipefail
cd "$(dirname "$0")"

usage() {
  cat <<'END'
./test.sh

Installs the packages of the tests and runs ./run.sh. Checks the formatting, then runs the reference cases, the readers
under sanitizers and every test: half an hour or more. No options.
END
}
for option in "$@"; do
  case $option in
    -h | --help) usage; exit 0 ;;
    *) echo "test.sh: unknown option '$option'. See ./test.sh --help." >&2; exit 2 ;;
  esac
done

./setup.sh --tests
./run.sh

git ls-files -z '*.cpp' '*.hpp' '*.c' '*.h' | xargs -0 -n 100 -P "$(nproc)" clang-format --dry-run -Werror
echo "formatting: equal to .clang-format"

export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 QT_QPA_PLATFORM=offscreen
preset=release sanitizer=asan-ubsan
[ "${CI:-}" = true ] && preset=ci-release sanitizer=ci-asan-ubsan
build/$preset/bin/adore validate tests/reference/*.json
cmake --build --preset "$preset"

echo "sanitizers: preset $sanitizer"
cmake --preset "$sanitizer" >/dev/null
cmake --build --preset "$sanitizer" --target test_base test_bearing test_deck test_results fuzz_readers
ctest --test-dir "build/$sanitizer" --output-on-failure -L unit -LE slow -j2

echo "tests: preset $preset"
ctest --test-dir "build/$preset" --output-on-failure -j2
