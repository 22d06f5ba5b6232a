# cmake -DONE=... -DOTHER=... -P Compare.cmake: fails where one program prints another line.
foreach (program IN ITEMS ONE OTHER)
  execute_process(
    COMMAND "${${program}}"
    OUTPUT_VARIABLE ${program}_text
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" ${program}_lines "${${program}_text}")
endforeach ()

foreach (one other IN ZIP_LISTS ONE_lines OTHER_lines)
  if (NOT one STREQUAL other)
    message(SEND_ERROR "${ONE}: ${one}\n${OTHER}: ${other}")
  endif ()
endforeach ()
