# Where each kind of package puts the tree.
if (CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr/lib/cartesianmesher)
endif ()
