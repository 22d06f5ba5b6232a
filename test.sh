#!/bin/sh
# Installs what is missing, looks at style and spelling, builds, runs every test that is not slow, and clang-tidy on
# what changed. Then, of the kernel alone, a chosen set of its tests under the address and undefined sanitizers. The
# builds are in build/release and build/asan. Prints at its end the minutes of processor time that each step took, of
# 40 that it may take, and the slowest tests.
#
# On Debian 13 and unstable: the release build and its tests alone. Style, clang-tidy and the instrumented
# builds are those of Debian 12's tools: others format otherwise, and warn of other things.
#
# What takes longer is in .ci/full.
set -eu
cd "$(dirname "$(readlink -f "$0")")"
. .ci/steps
trap 'print_steps' EXIT

step "install" .ci/install
if [ "$(. /etc/os-release && echo "${VERSION_ID:-}")" != 12 ]; then
  preset release
  exit
fi
step "style" .ci/style
preset release
step "clang-tidy" .ci/tidy
preset asan
