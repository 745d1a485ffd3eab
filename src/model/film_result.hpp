#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec2.hpp"
#include "model/film.hpp"
#include "model/grain_swing.hpp"
#include "model/lockin_maps.hpp"
#include "model/packing.hpp"
#include "model/picture_grains.hpp"
#include "model/result.hpp"

namespace arenite {

/// What a simulation of the same grains says beside the film; arrays as long as the grains, Pa, tension positive.
struct FilmTwin {
  std::vector<double> swing;        ///< sigma_hyd at the largest load less that at the smallest
  std::vector<double> state;        ///< sigma_hyd at the largest load, as the thesis compares
  bool empty() const { return swing.empty(); }
};

/// What a film of a loaded packing gives: maps in kelvin, rows from the top, and grains. Grains and contacts with their
/// inferred forces are `packing`; the arrays beside it follow its order. One file in the store.
struct FilmResult {
  Provenance provenance;
  std::string name;
  bool converged = true;
  std::string outcome;              ///< one sentence
  FilmInfo film;                    ///< without time stamps
  double pixel = 0;                 ///< m
  Vec2 origin;                      ///< centre of the upper left pixel, m; x right, y up
  std::vector<float> picture;       ///< mean of the frames at the smallest load, K
  std::vector<std::uint8_t> bad;    ///< 1 for pixels that were replaced
  LockinMaps maps;                  ///< where motion was taken out, with the grains as they are at the largest load
  PictureGrains grains;             ///< at the smallest load
  GrainMotion motion;               ///< empty where none was fitted
  GrainSwing swing;
  Packing packing;                  ///< in metres at the largest load; forces are those of the swing
  std::vector<double> fn_error, ft_error;  ///< N, one a contact
  std::vector<std::uint8_t> absent; ///< 1 for contacts that may not be there
  FilmTwin twin;
  std::string numbers_json;
};

}  // namespace arenite
