# Builds the page PAGE of WEB as the file OUTPUT.
include(${CMAKE_CURRENT_LIST_DIR}/node.cmake)
find_node(FATAL_ERROR)
execute_process(COMMAND ${NODE} build.mjs ${OUTPUT} ${PAGE} WORKING_DIRECTORY ${WEB} COMMAND_ERROR_IS_FATAL ANY)
