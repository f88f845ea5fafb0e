#!/usr/bin/env bash
# Builds the Debian packages, checks them with lintian, installs them in a root made by mmdebstrap, goes from a deck to
# pictures there, and removes them. Needs root (or user namespaces), mmdebstrap, lintian, and the Debian archive.
#   tests/package/run.sh [--keep]    --keep leaves the root in build/package/root
# Exit 0: all of it works. 77: not root.
set -euo pipefail
cd "$(dirname "$0")/../.."
[ "$(id -u)" -eq 0 ] || { echo "packages: making a root takes root"; exit 77; }
./setup.sh --packages

appstreamcli validate --no-net resources/applications/*.metainfo.xml
desktop-file-validate resources/applications/*.desktop

build=$PWD/build/package
strict=OFF; [ "${CI:-}" = true ] && strict=ON
cmake --preset package -DADORE_WARNINGS_AS_ERRORS=$strict >/dev/null
cmake --build --preset package
./setup.sh --docs
/usr/bin/python3 resources/docs/build_site.py "$build/bin/adore" "$build/docs"
rm -rf "$build/packages"
cpack --preset package
packages=("$build"/packages/*.deb)
[ ${#packages[@]} -eq 5 ] || { echo "five packages are expected, these were made: ${packages[*]}"; exit 1; }
lintian --fail-on error --suppress-tags bad-distribution-in-changes-file "${packages[@]}"

root=$build/root
rm -rf "$root"
mirror=$(sed -n 's/^deb \(\[[^]]*\] \)\{0,1\}\([^ ]*\) bookworm main.*/\2/p;s/^URIs: *\([^ ]*\).*/\1/p' \
  /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -n 1 || true)
mkdir -p "$root"
mmdebstrap --variant=minbase bookworm "$root" ${mirror:+"$mirror"}
[ -f /etc/apt/apt.conf ] && cp /etc/apt/apt.conf "$root/etc/apt/apt.conf"
cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
mkdir -p "$root/packages"
cp "${packages[@]}" "$root/packages"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
mount --bind /proc "$root/proc" && trap 'umount "$root/proc"' EXIT
inside sh -c 'apt-get update -q && apt-get install -y -q --no-install-recommends /packages/*.deb'
inside sh -euc '
  mkdir /job && cd /job
  adore new ball --out DATA.txt --set maxStps=60
  adore run .
  adore plot SOL1 SOL7 --out pictures
  adore animate SOL8 --view bearing --frame 1 --out pictures
  QT_QPA_PLATFORM=offscreen adrinput DATA.txt --render pictures/input
  python3 -c "import adore; print(adore.new(\"ball\").statics())"
  test -s PRINT.txt && test -s /usr/share/doc/adore-doc/html/index.html
  ls pictures/*.png | wc -l
  man_page=/usr/share/man/man1/adore.1.gz; test -s "$man_page"
'
inside sh -c 'apt-get remove -y -q adore adore-apps libadore-dev python3-adore adore-doc'
left=$(cd "$root" && find usr etc var/lib -iname '*adore*' -not -path '*/dpkg/*' -not -path '*/apt/*' | head)
[ -z "$left" ] || { echo "files stay behind: $left"; exit 1; }
[ "${1:-}" = --keep ] || { umount "$root/proc"; trap - EXIT; rm -rf "$root"; }
echo "packages: built, without errors of lintian, installed, deck to pictures, removed"
