#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/film.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/radiometry/band.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::thermography {

/// Digital level to temperature, as numbers at equal steps of the level between which it is straight; beyond the ends
/// the end pieces go on.
struct LevelCurve {
  double first = 0, step = 1;      ///< levels
  std::vector<float> temperature;  ///< K, at least two; empty: levels stay levels
};

/// A pixel that is not believed, and the pixels whose mean stands in for it.
struct Replacement {
  std::uint32_t pixel = 0;
  std::vector<std::uint32_t> from;  ///< empty if there is no good neighbour: the pixel stays as it is
};

/// For every marked pixel the good ones nearest to it: of its eight neighbours, or of wider rings where these are bad
/// too.
std::vector<Replacement> replacements(const std::vector<std::uint8_t>& bad, int width, int height);

/// What is done to every frame of a film, in this order; an empty array does nothing. Arrays are rows from the top.
struct Correction {
  int width = 0, height = 0;
  std::vector<float> gain, offset;  ///< level = gain * level + offset, pixel by pixel
  LevelCurve curve;
  std::vector<Replacement> bad;
  std::vector<float> reference;    ///< subtracted: a corrected frame of the unloaded sample, in the unit of the result
  std::vector<std::uint8_t> mask;  ///< 0: not of interest, given as 0
};

/// Corrects the frames of a block into `out`, frame after frame. Throws InputError if the correction is for another
/// size.
void apply(const Correction& correction, const FrameBlock& in, std::vector<float>& out);

/// A film seen through a correction: its pixels are floating, and K where the correction has a curve.
class CorrectedFilm : public FilmSource {
 public:
  /// Both must outlive it.
  CorrectedFilm(FilmSource& film, const Correction& correction);
  const FilmInfo& info() const override { return info_; }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override;

 private:
  FilmSource& film_;
  const Correction& correction_;
  FilmInfo info_;
  FrameBlock part_;
};

/// One-point correction: every pixel's offset, from the mean frame of a film of a black-body reference. Every pixel
/// then shows it at the median level of all.
void correct_offsets(const FrameStatistics& reference, Correction& correction);

/// Two-point correction: gain and offset of every pixel, from two black-body references of different temperature, so
/// that every pixel shows each of them at its median level. A pixel that hardly answers keeps gain 1 (find_bad_pixels
/// finds it). Throws InputError for references of different size, or that do not differ.
void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction);

/// The median level of a reference: where a correction puts it.
double reference_level(const FrameStatistics& reference);

/// A point of a calibration curve.
struct LevelPoint {
  double level = 0, temperature = 0;  ///< digital level, K
};

/// Levels for which a curve is made.
struct LevelRange {
  double low = 0, high = 16383;
};

/// Straight between the points of a black body, whatever their order; beyond them the last pieces go on. Throws
/// InputError for fewer than two points, two of one level, or temperatures that do not rise with the level. For a
/// surface that is not black what a level says of the photons stays, and a part of them is mirrored.
LevelCurve curve_through(std::vector<LevelPoint> points, const radiometry::Band& band = {},
                         const radiometry::Surface& surface = {}, const LevelRange& range = {});

/// Radiometry between two black-body references: the level is a straight line of the photons in the band, and a surface
/// that is not black shows eps N(T) + (1 - eps) N(T_amb).
LevelCurve curve_by_references(const radiometry::Band& band, const LevelPoint& cold, const LevelPoint& warm,
                               const radiometry::Surface& surface, const LevelRange& range = {});

/// Radiometry with one level known, which is that of a black surface: levels are proportional to photons.
LevelCurve curve_by_radiometry(const radiometry::Band& band, const LevelPoint& known,
                               const radiometry::Surface& surface, const LevelRange& range = {});

/// What temperatures were made with, and what grains are.
struct GrainSurfaces {
  radiometry::Band band;
  radiometry::Surface assumed;     ///< of everything in the film, so far
  std::vector<double> emissivity;  ///< of every material; empty: nothing is known of them
};

/// Maps in kelvin that were made as if everything were the assumed surface, as each grain's own material shows them:
/// its pixels' mean, and what varies about it by the slope of Planck's law there. A pixel belongs to the grain that
/// covers its middle, and those just beyond a rim to the nearest grain; the rest stays as it is. Maps are unchanged
/// where materials are as assumed.
void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces);

}  // namespace arenite::thermography
