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
add_custom_target(web)
# The page NAME (web/build.mjs) as report::FUNCTION() of report/page_template.hpp.
function(embed_page name function)
  set(html ${CMAKE_CURRENT_BINARY_DIR}/web/${name}.html)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/report/${function}.cpp)
  add_custom_command(
    OUTPUT ${html}
    COMMAND ${NODE} build.mjs ${html} ${name}
    DEPENDS ${web_installed} ${web}/build.mjs ${web_sources}
    WORKING_DIRECTORY ${web}
    COMMENT "Building the page: ${name}")
  add_custom_target(web_${name} DEPENDS ${html})
  add_dependencies(web web_${name})
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${html} -DOUTPUT=${source} -DHEADER=report/page_template.hpp -DFUNCTION=${function}
            -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${html} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake ${CMAKE_SOURCE_DIR}/cmake/raw_literals.cmake
    COMMENT "Embedding the page: ${name}")
  target_sources(arenite_core PRIVATE ${source})
endfunction()
embed_page(page page_template)
embed_page(study study_template)
add_dependencies(arenite_core web)
