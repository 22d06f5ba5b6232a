"""What pip calls: scikit-build-core, or what to do without it."""

import sys

MISSING = """
CartesianMesher is built by scikit-build-core, which this Python does not have.
- Debian 13 and later: apt install python3-scikit-build-core
- Debian 12 has no such package. Build the module without pip (cmake --preset vtk && cmake --build --preset vtk), or
  install ParaView's package (cartesianmesher_*.deb): see Plugin/Help/install.md.
"""

try:
    from scikit_build_core.build import *  # noqa: F403
except ModuleNotFoundError:

    def prepare_metadata_for_build_wheel(*_arguments):
        sys.exit(MISSING)

    build_wheel = prepare_metadata_for_build_wheel
