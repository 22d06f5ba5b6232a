# What Python's package has beside VTK's wrappers: the function `mesh`, and its options from the panel's XML.
set(package "${python_packages}/cartesianmesher")
configure_file(Filters/Python/__init__.py "${package}/__init__.py" COPYONLY)

file(GLOB properties CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/Plugin/Properties/*.xml")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  Filters/Python/make_options.py Plugin/CartesianMesher.xml.in Plugin/Properties/reference.py ${properties})
execute_process(
  COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_SOURCE_DIR}/Filters/Python/make_options.py" "${package}/_options.py"
  COMMAND_ERROR_IS_FATAL ANY)

install(FILES "${package}/__init__.py" "${package}/_options.py" DESTINATION "${python_directory}/cartesianmesher")
