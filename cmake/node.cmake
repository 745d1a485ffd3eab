# Looks for npm and for Node.js 18 or newer (NPM, NODE); without them one sentence says what to do,
# as a message of that kind.
function(find_node kind)
  find_program(NPM npm)
  find_program(NODE NAMES node nodejs)
  set(found "they were not found")
  if(EXISTS "${NPM}" AND EXISTS "${NODE}")
    execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    string(REGEX REPLACE "^v" "" version "${version}")
    if(version VERSION_GREATER_EQUAL 18)
      return()
    endif()
    set(found "${NODE} is ${version}")
  endif()
  message(${kind} "The page is built with npm and Node.js 18 or newer, and ${found}: install them (Debian: apt-get "
                  "install nodejs npm), or take built pages, which need neither: -DARENITE_PAGES=FOLDER (a release's "
                  "archive has them in web/built and needs nothing).")
endfunction()
