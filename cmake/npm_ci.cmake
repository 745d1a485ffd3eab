# Installs what web/package-lock.json lists, and says in one sentence what is missing when that fails.
include(${CMAKE_CURRENT_LIST_DIR}/node.cmake)
find_node(FATAL_ERROR)
execute_process(COMMAND ${NPM} ci --prefer-offline --no-audit --no-fund --loglevel=error
                WORKING_DIRECTORY ${WEB} RESULT_VARIABLE status OUTPUT_QUIET)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm could not install the page's packages (web/package-lock.json): building the page for the "
                      "first time needs npm's registry or a filled npm cache; built pages "
                      "(-DARENITE_PAGES=FOLDER) need neither.")
endif()
file(TOUCH ${WEB}/node_modules/.package-lock.json)
