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
  study/recipe.hpp
  study/recipe_templates.hpp
  study/run.hpp
  dem/engine.hpp
  dem/run_stage.hpp
  texture/texture.hpp
  cement/cement.hpp
  raster/raster.hpp
  peridynamics/load.hpp
  stress/stress.hpp
  thermography/lockin.hpp
  io/stage_file.hpp
  io/field_file.hpp
  io/run_folder.hpp
  io/film.hpp)
