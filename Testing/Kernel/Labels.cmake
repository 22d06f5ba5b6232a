# Read by ctest: which of the kernel's tests run where. `slow` ones in .ci/full only, the others, `quick`, in .ci/run too; of
# these, `sanitize` under the address sanitizer, which takes ten times as long: half of them by the time that they take, each
# concept once (.ci/full runs the rest). Those of TestThreads are `threads`, the
# thread sanitizer's.

# Ten seconds or more, together, in an optimised build.
set(slow
  Order[.]OfTheInputDoesNotMatter
  Shaping[.]CollapsedEdges
  Stops[.]NoStage
  WholeRefinedMeshOfShapedCells/)

# Three seconds or more under the sanitizer.
set(heavy
  Arrangement[.]MeshesOfBodies
  Baffles[.]AcrossADuct Baffles[.]StandOnBodies
  Balance[.]Axes Balance[.]Holds Balance[.]Reaches Balance[.]TransitionLayersAreBetween
  CellBudget[.]Curvature CellBudget[.]Gaps CellBudget[.]TheSame
  ExpectedMesh[.]AsMany
  FidelityOf[.]TheBoundary
  FlatFaces[.]SheetsHaveNone
  Flawed[.]AtRandom
  Flaws[.]BodiesThatCross Flaws[.]OneTriangleInAHundred
  Fuzz[.]RandomBytes Fuzz[.]Corpus # libFuzzer's short run does the same
  Fuzz[.]Tetrahedra Fuzz[.]Voxels
  KeepPoints[.]TheMesh
  Parts[.]AreTheWholeMesh
  PlanePerturbation[.]Cylinders
  PointKinds[.]AreThose
  PrismStacks[.]AreComplete PrismStacks[.]AreNoFilms PrismStacks[.]AreTheSame PrismStacks[.]DifferOn
  PrismStacks[.]FillASphere PrismStacks[.]FollowTheBoxes PrismStacks[.]Slide PrismStacks[.]StayIn
  RandomEdits[.]KeepTheMeshOne
  Refinement[.]Random Refinement[.]SameMesh
  Regions[.]AClosedWall Regions[.]AreValid Regions[.]CloseAnyGap Regions[.]Curved Regions[.]EndFlush
  Regions[.]LieInEachOther Regions[.]MayBe Regions[.]MayLie Regions[.]MayTouchAPlane Regions[.]MeetAlong
  Regions[.]ShareAPart Regions[.]TheFirstWall Regions[.]ThreeThat Regions[.]WallsBeyond
  Resources[.]ANodeOfMany Resources[.]MemoryIsEstimated
  Shaping[.]Fuzzed
  SizeEstimate[.]AsMany
  Sizing[.]AsMany Sizing[.]NoBox Sizing[.]SameBoxes
  SolverReady[.]Mending
  Statistics[.]CellsLeftOut Statistics[.]FitTogether
  Symmetry[.]Translation
  TrianglePairs[.]FansOfSlivers
  TrueVolume[.]IsNothing
  TubeRims[.]AreEdges
  UnitedBodies[.]FlatOrnaments)

# The same code again: on more threads, for which there is the thread sanitizer, or in another order.
set(again
  Threads AnyOrder OrOrder OrTheOrder Permuted)

# Of tests of many shapes, those of these: few triangles in few boxes, along the axes and not, thick and thin.
set(small "/(LShape|Needle|ThinPlateTurned|TurnedBox) ") # names end with "  # GetParam() = ..."

list(JOIN slow "|" slow)
list(JOIN heavy "|" heavy)
list(JOIN again "|" again)
foreach (test IN LISTS TestKernel_TESTS)
  set(labels quick)
  if (test MATCHES "${slow}")
    set(labels slow)
  elseif (NOT test MATCHES "${heavy}|${again}" AND (NOT test MATCHES "/" OR test MATCHES "${small}"))
    list(APPEND labels sanitize)
  endif ()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endforeach ()
foreach (test IN LISTS TestThreads_TESTS)
  set_tests_properties("${test}" PROPERTIES LABELS "quick;threads")
endforeach ()
