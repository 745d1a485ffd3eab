# The recipes that `arenite init` writes, src/recipe/templates/NAME.toml, as recipe::templates::NAME in the
# header recipe/templates.hpp.
include(cmake/raw_literals.cmake)
set(texts "")
foreach(name biaxial cemented collapse composite cycles deposit drum film rock shear silo spheres study)
  set(toml ${CMAKE_SOURCE_DIR}/src/recipe/templates/${name}.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${toml})
  raw_literals(${toml} literals)
  string(APPEND texts "inline constexpr std::string_view ${name} =\n${literals};\n")
endforeach()
file(CONFIGURE OUTPUT generated/recipe/templates.hpp @ONLY
  CONTENT "#pragma once\n#include <string_view>\n\nnamespace arenite::recipe::templates {\n${texts}\
}  // namespace arenite::recipe::templates\n")
