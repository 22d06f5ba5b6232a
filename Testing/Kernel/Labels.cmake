# Read by ctest: which of the kernel's tests run where. `slow` ones in .ci/full only, the others, `quick`, in .ci/run too; of
# these, `sanitize` under the address sanitizer, which takes ten times as long. Those of TestThreads are `threads` as well:
# the thread sanitizer's.

# Ten seconds or more in an optimised build.
set(slow
  Order[.]OfTheInputDoesNotMatter
  Shaping[.]CollapsedEdges
  WholeRefinedMeshOfShapedCells/Torus)

# A second or more.
set(heavy
  Baffles[.]AcrossADuct
  Balance[.]Axes Balance[.]Holds Balance[.]Reaches
  CellBudget[.]Curvature CellBudget[.]Gaps CellBudget[.]TheSame
  Flawed[.]AtRandom
  Flaws[.]BodiesThatCross Flaws[.]OneTriangleInAHundred
  Fuzz[.]RandomBytes Fuzz[.]Corpus # libFuzzer's short run does the same
  KeepPoints[.]TheMesh
  Parts[.]AreTheWholeMeshAround Parts[.]AreTheWholeMeshFar Parts[.]AreTheWholeMeshOf
  PatchMethods[.]Threads
  PrismStacks[.]AreTheSame PrismStacks[.]FillASphere
  Refinement[.]Random Refinement[.]SameMesh
  Regions[.]AClosedWall Regions[.]AreValid Regions[.]Curved Regions[.]EndFlush Regions[.]LieInEachOther
  Regions[.]MayBeSmooth Regions[.]MayLie Regions[.]MayTouchAPlane Regions[.]TheFirstWall Regions[.]WallsBeyond
  Resources[.]ANodeOfMany
  Shaping[.]Fuzzed
  SizeEstimate[.]AsMany
  SolverReady[.]Mending
  Stops[.]NoStage
  TrianglePairs[.]FansOfSlivers)

# Of tests of many shapes, those of these: few triangles in few boxes.
set(small "/(BoxesTouchingInAnEdge|Cube|CubeTurned|LShape|Needle|Octahedron|PlateOneLevelThick|StarPolyhedron|Tetrahedron|\
ThinPlateTurned|TurnedBox) ") # names end with "  # GetParam() = ..."

list(JOIN slow "|" slow)
list(JOIN heavy "|" heavy)
foreach (test IN LISTS TestKernel_TESTS)
  set(labels quick)
  if (test MATCHES "${slow}")
    set(labels slow)
  elseif (NOT test MATCHES "${heavy}" AND (NOT test MATCHES "/" OR test MATCHES "${small}"))
    list(APPEND labels sanitize)
  endif ()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endforeach ()
foreach (test IN LISTS TestThreads_TESTS)
  set_tests_properties("${test}" PROPERTIES LABELS "quick;sanitize;threads")
endforeach ()
