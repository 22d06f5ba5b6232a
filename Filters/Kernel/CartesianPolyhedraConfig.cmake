# find_package(CartesianPolyhedra) defines CartesianMesher::CartesianPolyhedra, whose headers are named by their rooms:
# #include "Quality/QualityMeasures.h".
include(CMakeFindDependencyMacro)
find_dependency(Threads)
include("${CMAKE_CURRENT_LIST_DIR}/CartesianPolyhedra-targets.cmake")
