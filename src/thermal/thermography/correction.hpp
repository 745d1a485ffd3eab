#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/film.hpp"
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

/// For every marked pixel the good ones nearest to it: of its eight neighbours, or of wider rings where these are bad too.
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

/// Corrects the frames of a block into `out`, frame after frame. Throws InputError if the correction is for another size.
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

/// One-point correction: every pixel's offset, from the mean frame of a film of a black-body reference. Every pixel then shows it
/// at the median level of all.
void correct_offsets(const FrameStatistics& reference, Correction& correction);

/// Two-point correction: gain and offset of every pixel, from two black-body references of different temperature, so that every
/// pixel shows each of them at its median level. A pixel that hardly answers keeps gain 1 (find_bad_pixels finds it).
/// Throws InputError for references of different size, or that do not differ.
void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction);

/// The median level of a reference: where a correction puts it.
double reference_level(const FrameStatistics& reference);

}  // namespace arenite::thermography
