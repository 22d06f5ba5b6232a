# SPDX-License-Identifier: BSD-3-Clause
"""Errors fall as they should where boxes are halved: two cases of Testing/Validation at their coarser sizes. Their figures
are on the guide's page validation."""

import harness
import made
import pipe


def rows(case):
    return [case.row(harness.OURS, size, harness.AS_IT_IS) for size in case.sizes[:2]]


found = rows(made.CASE)
order = harness.order(found, "mean error")
print("made solution:", order, found)
assert order > 1.8, order

found = rows(pipe.CASE)
order = harness.order(found, "wall shear")
print("pipe:", order, found)
assert order > 1.8 and abs(found[-1]["figures"]["pressure"]) < 0.01, order
