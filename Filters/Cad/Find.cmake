# CARTESIANMESHER_CAD: whether CAD files are read. Without read-cad, CAD Reader says what to install.
get_property(definitions DIRECTORY PROPERTY COMPILE_DEFINITIONS)
find_package(OpenCASCADE QUIET) # no version: it takes its own only
set_property(DIRECTORY PROPERTY COMPILE_DEFINITIONS "${definitions}") # it defines HAVE_TBB and others for all that follows
option(CARTESIANMESHER_CAD "Build the program that reads CAD files: needs Open CASCADE" ${OpenCASCADE_FOUND})

set(cad_packages "Open CASCADE's development files (Debian: libocct-data-exchange-dev, libtbb-dev, libfontconfig-dev)")
if (CARTESIANMESHER_CAD AND NOT OpenCASCADE_FOUND)
  message(FATAL_ERROR "CARTESIANMESHER_CAD is ON: install ${cad_packages}, or give their folder as OpenCASCADE_DIR; or "
    "configure with -DCARTESIANMESHER_CAD=OFF, which makes a CAD Reader that reads nothing")
elseif (NOT CARTESIANMESHER_CAD)
  message(STATUS "CAD files will not be read. For STEP, IGES and BREP: install ${cad_packages}, and configure with "
    "-DCARTESIANMESHER_CAD=ON")
endif ()
set(cad_directory "${CMAKE_INSTALL_LIBEXECDIR}/cartesianmesher")

set(cad_formats TKXDESTEP TKXDEIGES TKSTEP TKSTEPBase TKIGES)
if (TARGET TKDESTEP) # from Open CASCADE 7.8 on
  set(cad_formats TKDESTEP TKDEIGES)
endif ()
