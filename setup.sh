#!/usr/bin/env bash
# Installs the packages of Debian 12 that Adore needs. Safe to run again.
#   ./setup.sh           packages to build and run
#   ./setup.sh --tests   and packages of tests, which are skipped without them
#   ./setup.sh --docs    and packages of ./docs.sh
#   ./setup.sh --packages  and packages of tests/package/run.sh
set -euo pipefail

for option in "$@"; do
  case $option in
    --tests | --docs | --packages) ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
    *) echo "setup.sh: unknown option '$option'. See ./setup.sh --help." >&2; exit 2 ;;
  esac
done

packages=(
  # compiler and build
  g++ cmake ninja-build git ca-certificates
  # solver
  libeigen3-dev libsundials-dev libhdf5-dev libfmt-dev nlohmann-json3-dev libcli11-dev libmuparser-dev libtomlplusplus-dev
  musl-dev  # its sin, exp, pow ... give the same digits on every x86-64
  # desktop apps and pictures; Qt Charts' CMake files also ask for OpenGL and xkbcommon
  qt6-base-dev qt6-charts-dev libqt6opengl6-dev libgl1-mesa-dev libxkbcommon-dev fontconfig fonts-dejavu-core
  ffmpeg  # movies as MP4
  libjs-three  # pages with the 3D scene
  # the Python module; venv, setuptools and wheel for pip install ./core/python
  pybind11-dev python3-dev python3-numpy python3-pandas python3-venv python3-setuptools python3-wheel
  # tests and benchmarks
  catch2 libbenchmark-dev
  clang-format  # test.sh checks the formatting; another version would format differently
)
[ "${1:-}" = --tests ] && packages+=(
  gfortran               # user routines in Fortran
  xvfb openbox xdotool x11-utils  # real windows
  slurm-wlm munge        # a cluster of one node (tests/slurm)
  python3-h5py           # tables of studies (tests/cli/open_tables.py)
  codespell              # spelling (tests/language)
  chromium               # pages with the 3D scene
)
[ "${1:-}" = --docs ] && packages+=(
  python3-sphinx python3-myst-parser doxygen  # the documentation site, ./docs.sh
)
[ "${1:-}" = --packages ] && packages+=(
  mmdebstrap lintian appstream desktop-file-utils file dpkg-dev  # Debian packages in a clean root, tests/package/run.sh
)

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup: run this as root, or install sudo; missing: ${missing[*]}" >&2; exit 2; }
  as_root=(sudo)
fi
echo "setup: installing ${#missing[@]} packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
echo "setup: done"
