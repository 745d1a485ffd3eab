# What a program that uses the library needs: to make a packing, run a stage, load, measure, read results. Paths are below src/; what
# these include is installed with them, and <arenite/arenite.hpp> includes them all.
set(arenite_public_headers
  core/error.hpp
  core/units.hpp
  model/packing.hpp
  model/result.hpp
  model/phase_map.hpp
  model/stress_field.hpp
  model/field_result.hpp
  recipe/recipe.hpp
  recipe/recipe_templates.hpp
  workflow/run.hpp
  grains/dem/engine.hpp
  grains/dem/run_stage.hpp
  grains/texture/texture.hpp
  solid/cement/cement.hpp
  solid/raster/raster.hpp
  solid/peridynamics/load.hpp
  solid/stress/stress.hpp
  thermal/thermography/lockin.hpp
  io/stage_file.hpp
  io/field_file.hpp
  io/run_folder.hpp
  io/film.hpp)
