# The library for other programs: libarenite.a, public headers, find_package(Arenite) and pkg-config arenite.
include(cmake/public_headers.cmake)
include(CMakePackageConfigHelpers)

# `headers` and all that they include of src/, each once, in `out`.
function(with_includes headers out)
  set(open ${headers})
  set(found "")
  while(open)
    list(POP_FRONT open header)
    if(header IN_LIST found OR header STREQUAL "core/version.hpp")
      continue()
    endif()
    if(NOT EXISTS ${CMAKE_SOURCE_DIR}/src/${header})
      message(FATAL_ERROR
        "cmake/public_headers.cmake: there is no src/${header}, which is public or included by a public header")
    endif()
    list(APPEND found ${header})
    file(STRINGS src/${header} lines REGEX "^#include \"")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${line})
      list(APPEND open ${included})
    endforeach()
  endwhile()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

set(include_home ${CMAKE_INSTALL_INCLUDEDIR}/arenite)
set(library_home ${CMAKE_INSTALL_LIBDIR})
with_includes("${arenite_public_headers}" installed_headers)
foreach(header ${installed_headers})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/${header})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES src/${header} DESTINATION ${include_home}/${folder} COMPONENT development)
endforeach()
list(TRANSFORM arenite_public_headers REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE all_headers)
string(REPLACE ";" "\n" all_headers "${all_headers}")
file(CONFIGURE OUTPUT library/arenite.hpp CONTENT "#pragma once\n#include \"core/version.hpp\"\n@all_headers@\n" @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/library/arenite.hpp DESTINATION ${include_home} COMPONENT development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/generated/core/version.hpp
  DESTINATION ${include_home}/core COMPONENT development)

# What no package or pkg-config file describes; the others are found where the library is used
# (AreniteConfig.cmake.in, arenite.pc.in).
set(named_links xxhash cholmod amd)
list(TRANSFORM named_links PREPEND -l OUTPUT_VARIABLE named_link_line)
list(JOIN named_link_line " " named_link_line)
file(RELATIVE_PATH prefix_from_pkgconfig /${library_home}/pkgconfig /)
configure_file(cmake/arenite.pc.in library/arenite.pc @ONLY)
configure_package_config_file(cmake/AreniteConfig.cmake.in library/AreniteConfig.cmake
  INSTALL_DESTINATION ${library_home}/cmake/Arenite PATH_VARS include_home library_home)
write_basic_package_version_file(library/AreniteConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS arenite_core ARCHIVE COMPONENT development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/library/arenite.pc
  DESTINATION ${library_home}/pkgconfig COMPONENT development)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/library/AreniteConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/library/AreniteConfigVersion.cmake
  DESTINATION ${library_home}/cmake/Arenite COMPONENT development)
