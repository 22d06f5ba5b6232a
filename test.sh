#!/bin/sh
# Installs what is missing, builds, runs every test; then the kernel's again under the address and
# undefined sanitizers. A short run of the fuzzer follows. The builds are in build/release,
# build/asan and build/fuzz.
set -eu
cd "$(dirname "$(readlink -f "$0")")"

.ci/install
for preset in release asan fuzz; do
  cmake --preset $preset --log-level=WARNING
  cmake --build --preset $preset
  ctest --preset $preset
done
