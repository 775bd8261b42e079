# What the scripts share. Source it: it changes into the project's folder and stops the script at the first failure.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# As many compilers as there are cores, but no more than memory holds at 1 GiB each.
usable_cores() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
  if [ "$memory" -lt 1 ]; then memory=1; fi
  echo $((cores < memory ? cores : memory))
}

# configure PRESET [CMAKE ARGUMENTS…]: says nothing unless it fails.
configure() {
  local preset=$1 log=build/$1-configure.log
  shift
  mkdir -p build
  cmake --preset "$preset" "$@" >"$log" 2>&1 || { cat "$log" >&2; return 1; }
}

# build PRESET [--target TARGETS…]
build() {
  local preset=$1
  shift
  cmake --build --preset "$preset" --parallel "$(usable_cores)" "$@"
}
