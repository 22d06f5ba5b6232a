# Read by ctest: which of the kernel's tests run where. `slow` ones in .ci/full only, the others, `quick`, in .ci/run too; of
# these, `sanitize` under the address sanitizer, which takes ten times as long. Those of TestThreads are `threads`, the
# thread sanitizer's.

# Ten seconds or more, together, in an optimised build.
set(slow
  Order[.]OfTheInputDoesNotMatter
  Shaping[.]CollapsedEdges
  WholeRefinedMeshOfShapedCells/)

# Half a second or more: four and more under the sanitizer.
set(heavy
  Baffles[.]AcrossADuct
  Balance[.]Axes Balance[.]Holds Balance[.]Reaches
  CellBudget[.]Curvature CellBudget[.]Gaps CellBudget[.]TheSame
  FidelityOf[.]TheBoundary
  Flawed[.]AtRandom
  Flaws[.]BodiesThatCross Flaws[.]OneTriangleInAHundred
  Fuzz[.]RandomBytes Fuzz[.]Corpus # libFuzzer's short run does the same
  Fuzz[.]Tetrahedra Fuzz[.]Voxels
  KeepPoints[.]TheMesh
  Parts[.]AreTheWholeMesh
  PatchMethods[.]Threads
  PrismStacks[.]AreComplete PrismStacks[.]AreNoFilms PrismStacks[.]AreTheSame PrismStacks[.]DifferOn
  PrismStacks[.]FillASphere PrismStacks[.]FollowTheBoxes PrismStacks[.]Slide
  RandomEdits[.]KeepTheMeshOne
  Refinement[.]Random Refinement[.]SameMesh
  Regions[.]AClosedWall Regions[.]AreValid Regions[.]CloseAnyGap Regions[.]Curved Regions[.]EndFlush
  Regions[.]LieInEachOther Regions[.]MayBe Regions[.]MayLie Regions[.]MayTouchAPlane Regions[.]MeetAlong
  Regions[.]ShareAPart Regions[.]TheFirstWall Regions[.]WallsBeyond
  Resources[.]ANodeOfMany Resources[.]MemoryIsEstimated
  Shaping[.]Fuzzed
  SizeEstimate[.]AsMany
  Sizing[.]AsMany Sizing[.]NoBox Sizing[.]SameBoxes
  SolverReady[.]Mending
  Statistics[.]FitTogether
  Stops[.]NoStage
  Symmetry[.]Translation
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
  set_tests_properties("${test}" PROPERTIES LABELS "quick;threads")
endforeach ()
