"""Runs the tests of a module."""

import sys


def run(functions):
    """Those that are tests; all of them, whatever fails."""
    failures = 0
    for name, test in list(functions.items()):
        if name.startswith("test_"):
            try:
                test()
            except AssertionError as failure:
                failures += 1
                print(f"{name}: {failure}")
    sys.exit(failures > 0)
