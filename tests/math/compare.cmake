# cmake -DPROGRAM=… -DWANTED=FILE -P compare.cmake: fails where the program does not print what the file holds.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE got COMMAND_ERROR_IS_FATAL ANY)
file(READ ${WANTED} wanted)
if(NOT got STREQUAL wanted)
  message(FATAL_ERROR "${PROGRAM} prints\n${got}instead of\n${wanted}")
endif()
