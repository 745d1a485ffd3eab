# The pages: built from web/ by npm and esbuild into one HTML file each, or taken as they were built; compiled into the
# library as text.
include(cmake/node.cmake)
include(cmake/page_sources.cmake)
set(ARENITE_PAGES "" CACHE PATH "Folder of built pages (as the target `pages` makes it): Node.js is not needed then")
set(web ${CMAKE_SOURCE_DIR}/web)

# Sets built_pages to the folder whose pages are taken as they are, if any. Those of a release's archive (web/built)
# count as long as nobody has changed web/ since.
set(built_pages "")
foreach(folder ${ARENITE_PAGES} ${web}/built)
  if(built_pages OR NOT EXISTS ${folder}/page.html OR NOT EXISTS ${folder}/study.html)
    continue()
  endif()
  set(hash "")
  if(EXISTS ${folder}/sources.sha256)
    file(STRINGS ${folder}/sources.sha256 hash LIMIT_COUNT 1)
  endif()
  hash_of_page_sources(${web} wanted)
  if(hash STREQUAL wanted OR folder STREQUAL ARENITE_PAGES)
    set(built_pages ${folder})
  endif()
  if(NOT hash STREQUAL wanted)
    message(WARNING "The pages in ${folder} were built from other sources than those in ${web}.")
  endif()
endforeach()
if(ARENITE_PAGES AND NOT built_pages STREQUAL ARENITE_PAGES)
  message(FATAL_ERROR "-DARENITE_PAGES=${ARENITE_PAGES}: there is no page.html and study.html; `ninja pages` makes "
                      "such a folder, in the build folder.")
endif()

add_custom_target(web)
if(built_pages)
  message(STATUS "Pages: as built, from ${built_pages}")
else()
  find_node(WARNING)
  set(web_installed ${web}/node_modules/.package-lock.json)
  add_custom_command(
    OUTPUT ${web_installed}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DNODE=${NODE} -DWEB=${web} -P ${CMAKE_SOURCE_DIR}/cmake/npm_ci.cmake
    DEPENDS ${web}/package.json ${web}/package-lock.json
    COMMENT "Installing the page's packages")
  file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${web}/src/*)
  add_custom_target(pages
    COMMAND ${CMAKE_COMMAND} -DWEB=${web} -DFROM=${CMAKE_CURRENT_BINARY_DIR}/web -DTO=${CMAKE_CURRENT_BINARY_DIR}/pages
            -P ${CMAKE_SOURCE_DIR}/cmake/keep_pages.cmake
    COMMENT "Built pages: ${CMAKE_CURRENT_BINARY_DIR}/pages")
  add_dependencies(pages web)
endif()

# Builds the page NAME (web/build.mjs); `html` is where it is.
function(build_page name html)
  add_custom_command(
    OUTPUT ${html}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DNODE=${NODE} -DWEB=${web} -DPAGE=${name} -DOUTPUT=${html}
            -P ${CMAKE_SOURCE_DIR}/cmake/build_page.cmake
    DEPENDS ${web_installed} ${web}/build.mjs ${web_sources}
    COMMENT "Building the page: ${name}")
  add_custom_target(web_${name} DEPENDS ${html})
  add_dependencies(web web_${name})
endfunction()

# The page NAME as report::FUNCTION() of report/page_template.hpp.
function(embed_page name function)
  set(html ${built_pages}/${name}.html)
  if(NOT built_pages)
    set(html ${CMAKE_CURRENT_BINARY_DIR}/web/${name}.html)
    build_page(${name} ${html})
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/report/${function}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${html} -DOUTPUT=${source} -DHEADER=report/page_template.hpp -DFUNCTION=${function}
            -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${html} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake ${CMAKE_SOURCE_DIR}/cmake/raw_literals.cmake
    COMMENT "Embedding the page: ${name}")
  target_sources(arenite_core PRIVATE ${source})
  # A page is one string, however long.
  set_source_files_properties(${source} PROPERTIES
    COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:Clang>:-Wno-overlength-strings>")
endfunction()
embed_page(page page_template)
embed_page(study study_template)
add_dependencies(arenite_core web)
