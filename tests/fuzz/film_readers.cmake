# Film formats, as src/io/formats.hpp lists them: each a fuzz target and a replayed corpus.
file(STRINGS ${CMAKE_SOURCE_DIR}/src/io/formats.hpp listed REGEX "^#define ARENITE_FILM_FORMATS")
string(REGEX MATCHALL "each\\([a-z0-9_]+\\)" ARENITE_FILM_READERS "${listed}")
list(TRANSFORM ARENITE_FILM_READERS REPLACE "each\\((.*)\\)" "\\1")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/io/formats.hpp)
