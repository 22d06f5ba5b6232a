#!/bin/sh
# Installs what is missing, builds, runs every test; then the kernel's again under the address and
# undefined sanitizers. The builds are in build/release and build/asan.
set -eu
cd "$(dirname "$(readlink -f "$0")")"

.ci/install
for preset in release asan; do
  cmake --preset $preset --log-level=WARNING
  cmake --build --preset $preset
  ctest --preset $preset
done
