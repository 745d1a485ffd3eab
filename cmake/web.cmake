# The page (web/) is built by npm and esbuild into one HTML file and compiled into the library as text.
find_program(NPM npm)
find_program(NODE NAMES node nodejs)
if(NOT NPM OR NOT NODE)
  message(FATAL_ERROR "The page is built with Node.js 18 or newer and npm, and they were not found: "
                      "install them (Debian: apt-get install nodejs npm) and configure again.")
endif()
execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX REPLACE "^v" "" node_version "${node_version}")
if(node_version VERSION_LESS 18)
  message(FATAL_ERROR "The page is built with Node.js 18 or newer, and ${NODE} is ${node_version}: install a newer one "
                      "or name it with -DNODE=PATH.")
endif()

set(web ${CMAKE_SOURCE_DIR}/web)
set(web_installed ${web}/node_modules/.package-lock.json)
add_custom_command(
  OUTPUT ${web_installed}
  COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DWEB=${web} -P ${CMAKE_SOURCE_DIR}/cmake/npm_ci.cmake
  DEPENDS ${web}/package.json ${web}/package-lock.json
  COMMENT "Installing the page's packages")

file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${web}/src/*)
set(page_html ${CMAKE_CURRENT_BINARY_DIR}/web/page.html)
add_custom_command(
  OUTPUT ${page_html}
  COMMAND ${NODE} build.mjs ${page_html}
  DEPENDS ${web_installed} ${web}/build.mjs ${web_sources}
  WORKING_DIRECTORY ${web}
  COMMENT "Building the page")
add_custom_target(web DEPENDS ${page_html})

set(page_source ${CMAKE_CURRENT_BINARY_DIR}/generated/report/page_template.cpp)
add_custom_command(
  OUTPUT ${page_source}
  COMMAND ${CMAKE_COMMAND} -DINPUT=${page_html} -DOUTPUT=${page_source}
          -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
  DEPENDS ${page_html} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
  COMMENT "Embedding the page")
target_sources(arenite_core PRIVATE ${page_source})
add_dependencies(arenite_core web)
