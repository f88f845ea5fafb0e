#!/usr/bin/env bash
# Installs missing packages, builds the solver, simulates three example bearings and draws their pictures; then builds the applications.
set -euo pipefail
cd "$(dirname "$0")"

usage() {
  cat <<'END'
./run.sh

Installs missing packages (./setup.sh, which may ask for root) and builds the solver into build/release. Simulates three
example bearings and draws their pictures into out/example, out/example-cylindrical and out/example-tapered; earlier
results in these folders are replaced. Then builds AdrInput, AdrPlot, AGORE and the Python module. No options.
END
}
for option in "$@"; do
  case $option in
    -h | --help) usage; exit 0 ;;
    *) echo "run.sh: unknown option '$option'. See ./run.sh --help." >&2; exit 2 ;;
  esac
done

./setup.sh

# A clone in another folder shares the compiler cache.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
preset=release
[ "${CI:-}" = true ] && preset=ci-release
echo "build: preset $preset"
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target adore

bin=$PWD/build/$preset/bin
out=$PWD/out/example
rm -rf "$out"
mkdir -p "$out/pictures"
"$bin/adore" new ball --out "$out/DATA.txt"
echo "example: $out/DATA.txt"
"$bin/adore" run "$out"
"$bin/adore" plot "$out"/SOL[1-7] --out "$out/pictures"
"$bin/adore" animate "$out/SOL8" --view bearing --frame 1 --out "$out/pictures"
"$bin/adore" animate "$out/SOL8" --view cage --frame 1 --out "$out/pictures"

# Two roller bearings, with fewer pictures.
for type in cylindrical tapered; do
  folder=$PWD/out/example-$type
  rm -rf "$folder"
  mkdir -p "$folder/pictures"
  "$bin/adore" new "$type" --out "$folder/DATA.txt"
  "$bin/adore" run "$folder"
  "$bin/adore" plot "$folder/SOL1" --out "$folder/pictures"
  "$bin/adore" animate "$folder/SOL8" --view bearing --frame 1 --out "$folder/pictures"
done
echo "pictures: $out/pictures, $out-cylindrical/pictures and $out-tapered/pictures"

cmake --build --preset "$preset" --target adrinput adrplot agore adore_python
echo "done: results in $out, $out-cylindrical and $out-tapered"
echo "      open them: $bin/adrplot $out/SOL1    $bin/agore $out/SOL8    $bin/adrinput $out/DATA.txt"
