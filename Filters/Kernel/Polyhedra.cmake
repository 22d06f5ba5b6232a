# The quality and the formats of polyhedral meshes, whoever made them: a library of its own.
#
# Others have it by find_package(CartesianPolyhedra), once it is installed, which takes its component by name:
# cmake --install BUILD --component polyhedra --prefix DIR. Packages are without it. Its example is
# Testing/Package/Polyhedra.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# OpenFOAM's case texts (OpenFoam/Templates/README.md) become a source of the library.
set(templates "${CMAKE_CURRENT_SOURCE_DIR}/OpenFoam/Templates")
file(GLOB_RECURSE names CONFIGURE_DEPENDS RELATIVE "${templates}" "${templates}/*")
list(REMOVE_ITEM names README.md)
set(texts "#include \"OpenFoam/CaseTemplates.h\"\n\nconst cartesian::TemplateTexts& cartesian::builtInTemplates()\n{\n  static const TemplateTexts all = {\n")
foreach (name IN LISTS names)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${templates}/${name}")
  file(READ "${templates}/${name}" text)
  string(APPEND texts "{ \"${name}\", R\"template(${text})template\" },\n")
endforeach ()
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/BuiltInTemplates.new" "${texts}  };\n  return all;\n}\n")
file(COPY_FILE "${CMAKE_CURRENT_BINARY_DIR}/BuiltInTemplates.new" "${CMAKE_CURRENT_BINARY_DIR}/BuiltInTemplates.cpp"
  ONLY_IF_DIFFERENT)

add_library(CartesianPolyhedra STATIC
  "${CMAKE_CURRENT_BINARY_DIR}/BuiltInTemplates.cpp"
  Base/Execution.cpp
  Base/HelperThreads.cpp
  Base/NamePatterns.cpp
  Base/OutputFile.cpp
  Base/Recording.cpp
  Base/TaskOrder.cpp
  Lattice/Crossing.cpp
  Lattice/ExactFit.cpp
  Lattice/Lattice.cpp
  Lattice/MarchingCubes.cpp
  Lattice/Meshlines.cpp
  Lattice/Numbering.cpp
  Lattice/StarPolygons.cpp
  Polyhedra/CellEdges.cpp
  Polyhedra/OffsetPlanes.cpp
  Quality/CorrectionGain.cpp
  Quality/FaceList.cpp
  Quality/Histogram.cpp
  Quality/QualityMeasures.cpp
  Quality/SolverCheck.cpp
  Quality/WorstMeasure.cpp
  Sections/CellDivision.cpp
  Sections/FaceFans.cpp
  Sections/FlatCells.cpp
  Sections/FoldedPolygons.cpp
  Sections/OutlineFitting.cpp
  Sections/PeriodicFaces.cpp
  Sections/PlaneBuckets.cpp
  Sections/PlaneGraph.cpp
  Sections/PlaneOverlay.cpp
  Sections/PlanePolygons.cpp
  Sections/PlaneSection.cpp
  Sections/PolygonBridges.cpp
  Sections/SideFaces.cpp
  Sections/SideMerging.cpp
  Sections/SidePlane.cpp
  Sections/StarPoint.cpp
  Report/Canvas.cpp
  Report/HistogramDrawing.cpp
  Report/ReportPage.cpp
  OpenFoam/CaseFiles.cpp
  OpenFoam/CaseTemplates.cpp
  OpenFoam/ConditionChecks.cpp
  OpenFoam/Conditions.cpp
  OpenFoam/CyclicFaces.cpp
  OpenFoam/FaceAreas.cpp
  OpenFoam/FlowCase.cpp
  OpenFoam/FoamBoundary.cpp
  OpenFoam/FoamFile.cpp
  OpenFoam/FoamListReader.cpp
  OpenFoam/FoamPieceRegions.cpp
  OpenFoam/FoamPieces.cpp
  OpenFoam/FoamRegions.cpp
  OpenFoam/FrontalArea.cpp
  OpenFoam/HeatBalance.cpp
  OpenFoam/HeatCase.cpp
  OpenFoam/HexahedralBox.cpp
  OpenFoam/LabelRuns.cpp
  OpenFoam/LeastSystem.cpp
  OpenFoam/PeriodicDrive.cpp
  OpenFoam/PolyMeshFiles.cpp
  OpenFoam/PolyMeshReader.cpp
  OpenFoam/RefinementLevels.cpp
  OpenFoam/Rotations.cpp
  OpenFoam/Rows.cpp
  OpenFoam/SolverSetup.cpp
  OpenFoam/Substances.cpp
  OpenFoam/SymmetryPlanes.cpp
  OpenFoam/ThirdEdges.cpp
  OpenFoam/ZoneFaces.cpp
  Formats/AsciiNames.cpp
  Formats/EnSightFiles.cpp
  Formats/FacesOfCells.cpp
  Formats/FluentFile.cpp
  Formats/UniqueNames.cpp)
target_include_directories(CartesianPolyhedra PUBLIC
  "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>"
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/CartesianPolyhedra>")
target_compile_features(CartesianPolyhedra PUBLIC cxx_std_17)
target_link_libraries(CartesianPolyhedra PUBLIC Threads::Threads)
cartesian_kernel_library(CartesianPolyhedra)

set(component COMPONENT polyhedra EXCLUDE_FROM_ALL)
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/CartesianPolyhedra")
install(TARGETS CartesianPolyhedra EXPORT CartesianPolyhedra DESTINATION "${CMAKE_INSTALL_LIBDIR}" ${component})
foreach (room IN LISTS CARTESIAN_POLYHEDRA_ROOMS)
  install(DIRECTORY ${room} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/CartesianPolyhedra" ${component}
    FILES_MATCHING PATTERN "*.h")
endforeach ()
install(EXPORT CartesianPolyhedra FILE CartesianPolyhedra-targets.cmake NAMESPACE CartesianMesher::
  DESTINATION "${package}" ${component})
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/CartesianPolyhedraConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES CartesianPolyhedraConfig.cmake "${CMAKE_CURRENT_BINARY_DIR}/CartesianPolyhedraConfigVersion.cmake"
  DESTINATION "${package}" ${component})
