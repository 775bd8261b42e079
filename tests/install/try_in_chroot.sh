#!/usr/bin/env bash
# try_in_chroot.sh DEB…: makes a bare Debian 12 with debootstrap, installs the packages there with apt, runs what they brought as a
# user of that system would, purges them with all that came along, and says what is left. Needs root and Debian's archive.
set -euo pipefail
command -v debootstrap >/dev/null || { echo "try_in_chroot: it needs debootstrap" >&2; exit 1; }
root=$(mktemp -d)
chmod 755 "$root"
trap 'rm -rf --one-file-system "$root"' EXIT
archive=$(apt-get indextargets --format '$(SITE) $(RELEASE)' | awk '$2 == "bookworm" { print $1; exit }')
debootstrap --variant=minbase bookworm "$root" "$archive" >"$root.log" 2>&1 || { tail -n 20 "$root.log" >&2; exit 1; }
rm -f "$root.log"

inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive QT_QPA_PLATFORM=offscreen "$@"; }
files() { (cd "$root" && find etc opt usr var -not -path 'var/lib/apt/*' -not -path 'var/cache/*' -not -path 'var/log/*' \
  -not -path 'var/lib/dpkg/*' | sort); }

cp /etc/resolv.conf "$root/etc/resolv.conf"
cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
inside apt-get -qq update
before=$(files)
mkdir "$root/packages"
cp "$@" "$root/packages"
inside sh -c 'apt-get -qq -y --no-install-recommends install /packages/*.deb' >"$root/install.log" 2>&1 || { tail -n 30 "$root/install.log" >&2; exit 1; }
names=()
for package in "$@"; do names+=("$(dpkg-deb --field "$package" Package)"); done
echo "apt installed ${names[*]} on a bare Debian 12"

inside toolpace --version
inside toolpace plan /usr/share/toolpace/nc/pocket.ngc --machine /usr/share/toolpace/machines/mill-3axis.toml --setpoints /tmp/pocket.npy --verify | tail -n 1
inside python3 -B /usr/share/toolpace/python/zheng_table.py | tail -n 1
inside toolpace-studio /usr/share/toolpace/nc/pocket.ngc --screenshot /tmp/window.png 2>/dev/null
test -s "$root/tmp/window.png"

inside apt-get -qq -y purge "${names[@]}" >/dev/null 2>&1
inside apt-get -qq -y autoremove --purge >/dev/null 2>&1
ours=$(diff <(echo "$before") <(files) | grep -i toolpace || true)
[ -z "$ours" ] || { echo "left behind:"; echo "$ours"; exit 1; }
echo "purged, and nothing of it is left"
