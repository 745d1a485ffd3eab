#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "model/film.hpp"
#include "model/grain_motion.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite {

/// What a companion simulation of the same grains gives; arrays as long as the grains, Pa, tension positive.
struct FilmSimulation {
  std::vector<double> peak_to_peak;  ///< sigma_hyd at the largest load less that at the smallest
  std::vector<double> state;         ///< sigma_hyd at the largest load, as the thesis compares
  bool empty() const { return peak_to_peak.empty(); }
};

/// How contact forces agree with what they were inferred from, and with what was given beside the film.
struct ForceFit {
  std::size_t proposed = 0;               ///< contacts
  double present = 0, present_error = 0;  ///< number of contacts that are there, as far as forces and gaps show
  std::vector<float>
      picture;  ///< peak to peak, as the forces make the maps show it, K, rows from the top; no number outside grains
  double over_noise = 0;   ///< root mean square of measured less fitted over the measured noise alone (chi)
  double over_signal = 0;  ///< median size of measured less fitted over that of the measured
  double load = 0;         ///< on the lower wall by forces inferred without it, N; 0: not known
  double model_error = 0;  ///< error of the disks' fields, share of the signal, that makes the two agree
  std::vector<double> factor_scale,
      factor_scale_error;             ///< one a material: the film asks for a factor so many times larger
  double shift = 0, shift_error = 0;  ///< of all pixels together, as forces and balance show it, K peak to peak; error
                                      ///< 0: pixels share no noise
  double factor_scatter = 0;          ///< by which factors of grains scatter about those of their materials, relative
};

/// Light that lens and housing scatter far.
struct FilmHalo {
  double share = 0, error = 0;  ///< of the light
  double width = 0;             ///< standard deviation, pixels
  double cost = 0;              ///< what grain stresses would be off by with it, root mean square over the mean stress
};

/// A container whose sides were found where grains touch them; 0 where they are as given.
struct FilmWalls {
  Vec2 shift, shift_error;  ///< of the whole container in the film, m, y up
  BySide<double> inward{};  ///< what is left to single sides at the largest load, m
  Vec2 smaller;             ///< by which the container is smaller than given along x and y, m
  double travel = 0;        ///< of the lower wall, as grains show it, m; 0: as given
};

/// What a film of a loaded packing gives: maps in kelvin, rows from the top, and grains. Grains and contacts with their
/// inferred forces are `packing`; the arrays beside it follow its order. One file in the store.
struct FilmResult : ResultHead {
  FilmInfo film;                  ///< without time stamps
  double pixel = 0;               ///< m
  Vec2 origin;                    ///< centre of the upper left pixel, m; x right, y up
  std::vector<float> picture;     ///< mean of the frames at the smallest load, K
  std::vector<std::uint8_t> bad;  ///< 1 for pixels that were replaced
  LockinMaps maps;                ///< where motion was taken out, with the grains as they are at the largest load
  PictureGrains grains;           ///< at the smallest load
  GrainMotion motion;             ///< empty where none was fitted
  PeakToPeak peak_to_peak;
  Packing packing;                         ///< in metres at the largest load; forces are peak to peak
  std::vector<double> fn_error, ft_error;  ///< N, one a contact
  std::vector<double> presence;     ///< probability that each of the packing's contacts is there; the others that were
                                    ///< proposed are not kept
  ForceFit fit;                     ///< how well the forces agree with the film and the load; empty without forces
  double rim_blur = 0;              ///< of the lens as the rims show it, pixels; 0: not known
  FilmHalo halo;                    ///< that was taken off
  FilmWalls walls;                  ///< where the rims show the container, against where it was said to be
  std::vector<std::string> doubts;  ///< what the film says against what was given beside it, one sentence each
  FilmSimulation simulation;
  Numbers numbers;
};

}  // namespace arenite
