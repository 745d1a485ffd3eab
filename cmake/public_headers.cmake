# What a program that uses the library needs: to make a packing, run a stage, load, measure, read results. Paths are
# below src/; what these include is installed with them, and <arenite/arenite.hpp> includes them all.
set(arenite_public_headers
  core/error.hpp
  core/units.hpp
  statistics/numbers_text.hpp
  model/packing.hpp
  model/result.hpp
  model/measuring.hpp
  model/phase_map.hpp
  recipe/recipe.hpp
  workflow/make_packing.hpp
  workflow/run.hpp
  grains/dem/engine.hpp
  grains/dem/run_stage.hpp
  grains/texture/texture.hpp
  solid/cement/cement.hpp
  solid/grid/rasterise.hpp
  solid/peridynamics/load.hpp
  solid/stress/stress.hpp
  thermal/thermography/lockin.hpp
  io/results/results.hpp
  io/disk/store_file.hpp
  io/film/film.hpp)
