#!/usr/bin/env bash
# Installs what is missing, builds what the main job needs (the solver and its pictures), simulates the example bearing and draws its pictures into out/example; then a cylindrical and a tapered roller bearing beside it.
set -euo pipefail
cd "$(dirname "$0")"

usage() {
  cat <<'END'
./run.sh

Installs what is missing (./setup.sh, which may ask for root), builds the solver and its pictures into build/release,
simulates three example bearings and draws their pictures into out/example, out/example-cylindrical and
out/example-tapered. Earlier results in these three folders are replaced. It takes no options.
END
}
for option in "$@"; do
  case $option in
    -h | --help) usage; exit 0 ;;
    *) echo "run.sh: there is no option '$option'; ./run.sh --help tells what there is" >&2; exit 2 ;;
  esac
done

./setup.sh

# A clone in another folder shares the compiler cache.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
preset=release
[ "${CI:-}" = true ] && preset=ci-release
echo "build: preset $preset"
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target adore adrplot agore

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

# The same for rollers: a shorter way.
for type in cylindrical tapered; do
  folder=$PWD/out/example-$type
  rm -rf "$folder"
  mkdir -p "$folder/pictures"
  "$bin/adore" new "$type" --out "$folder/DATA.txt"
  "$bin/adore" run "$folder"
  "$bin/adore" plot "$folder/SOL1" --out "$folder/pictures"
  "$bin/adore" animate "$folder/SOL8" --view bearing --frame 1 --out "$folder/pictures"
done
echo "done: PRINT.txt, SOL1-SOL8 and RUN.json in $out, pictures in $out/pictures; rollers in $out-cylindrical and $out-tapered"
echo "      look at them in the apps: $bin/adrplot $out/SOL1    $bin/agore $out/SOL8"
