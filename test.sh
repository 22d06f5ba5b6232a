#!/bin/sh
# Installs what is missing, looks at style and spelling, builds, runs every test and clang-tidy on what
# changed. Then, of the kernel alone: its tests again and a short run of its fuzzer under the address and
# undefined sanitizers, the tests of threads under the thread sanitizer; and by clang the same meshes, bit for
# bit, as by gcc. The builds are in build/release, build/asan, and so on.
#
# On Debian 13 and unstable: the release build and its tests alone. Style, clang-tidy and the instrumented
# builds are those of Debian 12's tools: others format otherwise, and warn of other things.
set -eu
cd "$(dirname "$(readlink -f "$0")")"

began=$(date +%s)
step() {
  echo "=== $((($(date +%s) - began) / 60)) min: $*"
  "$@"
}
preset() {
  step cmake --preset "$1" --log-level=WARNING
  step cmake --build --preset "$1"
  step ctest --preset "$1"
}

.ci/install
if [ "$(. /etc/os-release && echo "${VERSION_ID:-}")" != 12 ]; then
  preset release
  exit
fi
step .ci/style
preset release
step .ci/tidy
for name in asan tsan clang; do
  preset $name
done
