# The recipes that `arenite init` writes, src/recipe/templates/NAME.toml, compiled into the library as recipe::NAME_text().
foreach(name composite cemented film study)
  set(toml ${CMAKE_SOURCE_DIR}/src/recipe/templates/${name}.toml)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/recipe/${name}_template.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${toml} -DOUTPUT=${source} -DHEADER=recipe/recipe.hpp -DROOM=recipe -DFUNCTION=${name}_text
            -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${toml} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake ${CMAKE_SOURCE_DIR}/cmake/raw_literals.cmake
    COMMENT "Embedding the recipe: ${name}")
  target_sources(arenite_core PRIVATE ${source})
endforeach()
