#!/usr/bin/env bash
# try_packages.sh DEB…: installs packages below a root of their own with dpkg, runs what they brought, and removes them again.
# What they depend on is looked up where apt knows Debian's packages, not installed.
set -euo pipefail
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
touch "$root/var/lib/dpkg/status"

in_root() { dpkg --root="$root" --log=/dev/null --force-depends --force-not-root --force-script-chrootless "$@" >/dev/null 2>&1 || dpkg --root="$root" --force-depends "$@"; }
installed() { (cd "$root" && find . -path ./var/lib/dpkg -prune -o -print | sort); }

before=$(installed)
in_root --install "$@"
names=()
for package in "$@"; do names+=("$(dpkg-deb --field "$package" Package)"); done
echo "installed: ${names[*]}, $(installed | wc -l) files and folders"

bin=$root/usr/bin
"$bin/toolpace" --version
"$bin/toolpace" plan "$root/usr/share/toolpace/nc/pocket.ngc" --machine "$root/usr/share/toolpace/machines/mill-3axis.toml" \
  --setpoints "$root/pocket.npy" --verify >/dev/null
rm "$root/pocket.npy"
test -s "$root/usr/share/man/man1/toolpace-plan.1"
bash -n "$root/usr/share/bash-completion/completions/toolpace"
if [ -x "$bin/toolpace-studio" ]; then
  QT_QPA_PLATFORM=offscreen "$bin/toolpace-studio" "$root/usr/share/toolpace/nc/pocket.ngc" --screenshot "$root/window.png" 2>/dev/null
  rm "$root/window.png"
fi
if [ -d "$root/usr/lib/python3/dist-packages/toolpace" ]; then
  PYTHONPATH=$root/usr/lib/python3/dist-packages /usr/bin/python3 -B "$root/usr/share/toolpace/python/zheng_table.py" >/dev/null
fi
for name in "${names[@]}"; do test -s "$root/usr/share/doc/$name/copyright"; done

in_root --purge "${names[@]}"
left=$(diff <(echo "$before") <(installed) || true)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "removed without a trace"

if command -v apt-cache >/dev/null && apt-cache show libc6 >/dev/null 2>&1; then
  needed=$(for package in "$@"; do dpkg-deb --field "$package" Depends | tr ',' '\n' | sed 's/[(|].*//; s/ //g'; done | sort -u |
    grep -vxF "$(printf '%s\n' "${names[@]}")")
  # shellcheck disable=SC2086
  missing=$(comm -23 <(echo "$needed") <(apt-cache --no-all-versions show $needed 2>/dev/null | sed -n 's/^Package: //p' | sort -u))
  [ -z "$missing" ] || { echo "not in Debian, though depended on:" $missing; exit 1; }
  echo "what they depend on is in Debian"
fi
