# Debian's packages of ParaView 5.13 and later name Python modules vtkX.so that are called
# vtkX.cpython-313-x86_64-linux-gnu.so, which find_package() refuses. Where the named ones are missing, the
# targets are made here before, with no file: CMake then leaves out its own. Nothing links to them.
function (cartesian_python_targets)
  file(GLOB lists
    "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/ParaViewPython*-targets.cmake"
    "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk/VTKPython-targets.cmake"
    "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/vtk-*/VTKPython-targets.cmake")
  foreach (list IN LISTS lists)
    string(REPLACE ".cmake" "-*.cmake" locations "${list}")
    file(GLOB locations "${locations}")
    if (NOT locations)
      continue ()
    endif ()
    file(STRINGS ${locations} modules REGEX "IMPORTED_LOCATION")
    string(REGEX MATCH "PREFIX}/([^\"]+)" module "${modules}")
    if (NOT module OR EXISTS "/usr/${CMAKE_MATCH_1}")
      continue ()
    endif ()
    file(STRINGS "${list}" targets REGEX "_expected_target IN ITEMS")
    string(REGEX REPLACE ".* IN ITEMS ([^)]*).*" "\\1" targets "${targets}")
    separate_arguments(targets)
    foreach (target IN LISTS targets)
      if (NOT TARGET ${target})
        add_library(${target} INTERFACE IMPORTED)
      endif ()
    endforeach ()
  endforeach ()
endfunction ()

cartesian_python_targets()
