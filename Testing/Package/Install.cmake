# cmake -DBUILD=... -DPREFIX=... -P Install.cmake: into an empty folder.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}"
  OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
