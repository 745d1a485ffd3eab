# What of ours reads anybody's bytes, but for films: each a fuzz target and a corpus.
set(ARENITE_READERS recipe csv picture phase_map spheres volume)
# Film formats, as src/io/formats.hpp lists them: each a name of the one program that reads films, and a corpus.
file(STRINGS ${CMAKE_SOURCE_DIR}/src/io/formats.hpp listed REGEX "^#define ARENITE_FILM_FORMATS")
string(REGEX MATCHALL "each\\([a-z0-9_]+\\)" ARENITE_FILM_READERS "${listed}")
list(TRANSFORM ARENITE_FILM_READERS REPLACE "each\\((.*)\\)" "\\1")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/io/formats.hpp)

# The program gets the names NAME_ptw and so on, by which it knows its format.
function(arenite_name_by_film_format program name)
  foreach(format ${ARENITE_FILM_READERS})
    add_custom_command(TARGET ${program} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E create_symlink ${program} $<TARGET_FILE_DIR:${program}>/${name}_${format})
  endforeach()
endfunction()
