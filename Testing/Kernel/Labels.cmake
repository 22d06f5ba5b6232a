# Read by ctest: which of the kernel's tests run where. `slow` ones in .ci/full only, the others, `quick`, in .ci/run too; of
# these, `sanitize` under the address sanitizer, which takes ten times as long. Those of TestThreads are `threads` as well:
# the thread sanitizer's.

cmake_policy(SET CMP0057 NEW) # if (IN_LIST)

# More than three seconds in an optimised build.
set(slow
  "Fuzz[.]StarPolyhedraFarAway")

# Too long under a sanitizer; others go the same ways through the kernel on smaller shapes.
set(heavy
  "CellBudget[.](Curvature|Gaps)"
  "SizeEstimate"
  "SmoothShape")

list(JOIN slow "|" slow)
list(JOIN heavy "|" heavy)
foreach (test IN LISTS TestKernel_TESTS TestThreads_TESTS)
  set(labels quick)
  if (test MATCHES "${slow}")
    set(labels slow)
  elseif (NOT test MATCHES "${heavy}")
    list(APPEND labels sanitize)
  endif ()
  if (test IN_LIST TestThreads_TESTS)
    list(APPEND labels threads)
  endif ()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endforeach ()
