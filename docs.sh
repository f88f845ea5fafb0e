#!/usr/bin/env bash
# Builds the documentation site into build/docs/html, without a network. It needs the program that ./run.sh builds.
set -euo pipefail
cd "$(dirname "$0")"

usage() {
  cat <<'END'
./docs.sh [ADORE]

Builds the documentation into build/docs/html; open index.html in a browser. Installs Sphinx, MyST and Doxygen if they
are missing (./setup.sh --docs). The generated reference pages come from the program ADORE (default: the one of
./run.sh) and from the Python module of the same build.
END
}
case "${1:-}" in
  -h | --help) usage; exit 0 ;;
  -*) echo "docs.sh: unknown option '$1'. See ./docs.sh --help." >&2; exit 2 ;;
esac

preset=release
[ "${CI:-}" = true ] && preset=ci-release
adore=${1:-build/$preset/bin/adore}
if [ ! -x "$adore" ]; then
  echo "docs.sh: $adore is missing. Build it with ./run.sh, or name the program: ./docs.sh ADORE" >&2
  exit 2
fi
./setup.sh --docs
/usr/bin/python3 resources/docs/build_site.py "$adore" build/docs
