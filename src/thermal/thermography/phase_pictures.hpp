#pragma once
#include <cstddef>
#include <vector>

#include "model/film.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {

/// Mean pictures of a cyclically loaded sample at phases of its load, as under a stroboscope: frames whose phase falls
/// into the same part of the cycle are averaged, less drift of the lock-in's order, which frames of a like phase tell. What
/// moves or warms with the load is in these few pictures with all of the film's signal to noise.
struct PhasePictures {
  int width = 0, height = 0;
  std::vector<double> frames;       ///< in every picture
  /// Means over the frames of every picture of cos and sin of the phase 2 pi f t and of twice the phase.
  std::vector<double> cosine, sine, cosine2, sine2;
  std::vector<float> spline;        ///< pictures x height x width: coefficients of the cubic spline through the pixels

  std::size_t size() const { return frames.size(); }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  const float* picture(std::size_t k) const { return spline.data() + k * pixels(); }
};

/// One pass over the film, with the frequency and the drift's order of its lock-in; pictures are at the film's mean. Parts of
/// the cycle in which there is no frame have no picture. Empty if `options.progress` stopped it.
PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options, std::size_t parts = 48);

/// One of the pictures itself, rows from the top.
std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k);

}  // namespace arenite::thermography
