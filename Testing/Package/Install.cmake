# cmake -DBUILD=... -DPREFIX=... [-DCOMPONENT=...] -P Install.cmake: into an empty folder.
if (COMPONENT)
  set(component --component "${COMPONENT}")
endif ()
file(REMOVE_RECURSE "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" ${component}
  OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
