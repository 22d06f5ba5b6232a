# The pages of this folder in ParaView's Help, compiled into the plugin. Without the tools, which
# ParaView's own packages do not bring, there is no Help; nothing else is missing.
find_program(CMARK_GFM cmark-gfm)
set(qt Qt5) # of ParaView 5.11, which does not say so
if (PARAVIEW_QT_MAJOR_VERSION)
  set(qt Qt${PARAVIEW_QT_MAJOR_VERSION})
endif ()
find_package(${qt} QUIET COMPONENTS Help)
find_package(Python3 3.9 QUIET COMPONENTS Interpreter)

# What makes HTML of XML, and how it says its version: Debian's xmlpatterns may be a wrapper with nothing in it.
if (ParaView_VERSION VERSION_LESS 6.0)
  find_program(TRANSFORMER NAMES xmlpatterns-qt5 xmlpatterns)
  set(version_option -version)
else ()
  find_program(TRANSFORMER xsltproc)
  set(version_option --version)
endif ()
set(works 1)
if (TRANSFORMER)
  execute_process(COMMAND "${TRANSFORMER}" ${version_option}
    RESULT_VARIABLE works OUTPUT_QUIET ERROR_QUIET)
endif ()

if (NOT works EQUAL 0 OR NOT CMARK_GFM OR NOT ${qt}Help_FOUND OR NOT Python3_Interpreter_FOUND)
  message(STATUS "No help pages: they need xmlpatterns or xsltproc, qhelpgenerator, cmark-gfm and Python")
  set(help_arguments XML_DOCUMENTATION OFF)
  return ()
endif ()

set(converter "${CMAKE_CURRENT_LIST_DIR}/convert.py")
set(help_folder "${CMAKE_CURRENT_BINARY_DIR}/help")
file(GLOB pages CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.md" "${CMAKE_CURRENT_LIST_DIR}/*.png")
add_custom_command(
  OUTPUT "${help_folder}/index.html"
  COMMAND Python3::Interpreter -B "${converter}" pages "${CMARK_GFM}" "${help_folder}"
  DEPENDS "${converter}" "${CMAKE_CURRENT_LIST_DIR}/../Properties/reference.py" ${pages}
    "${CMAKE_CURRENT_BINARY_DIR}/CartesianMesher.xml"
  COMMENT "Converting the help pages"
  VERBATIM)

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS Help/README.md "${converter}")
execute_process(COMMAND "${Python3_EXECUTABLE}" -B "${converter}" contents
  OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)

# ParaView makes a page of its own for each proxy; ours are copied over them.
set(help_arguments
  DOCUMENTATION_DIR "${help_folder}"
  DOCUMENTATION_DEPENDENCIES "${help_folder}/index.html"
  DOCUMENTATION_TOC "${contents}")
