#include "thermal/thermography/correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/median.hpp"

namespace arenite::thermography {
namespace {

template <class T> void take_levels(const Correction& c, const T* in, float* out, std::size_t n) {
  if (c.gain.empty()) {
    for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<float>(in[i]);
    return;
  }
  const float *gain = c.gain.data(), *offset = c.offset.data();
  for (std::size_t i = 0; i < n; ++i) out[i] = gain[i] * static_cast<float>(in[i]) + offset[i];
}

void to_temperature(const LevelCurve& curve, float* out, std::size_t n) {
  const auto first = static_cast<float>(curve.first), per_level = static_cast<float>(1 / curve.step);
  const auto last = static_cast<float>(curve.temperature.size() - 2);
  const float* at = curve.temperature.data();
  for (std::size_t i = 0; i < n; ++i) {
    const float x = (out[i] - first) * per_level;
    const float held = std::max(0.0F, std::min(x, last));  // a level that is no number ends up at the first place
    const int k = static_cast<int>(held);
    out[i] = at[k] + (x - static_cast<float>(k)) * (at[k + 1] - at[k]);
  }
}

void replace_bad(const std::vector<Replacement>& bad, float* out) {
  for (const Replacement& r : bad) {
    if (r.from.empty()) continue;
    float sum = 0;
    for (const std::uint32_t p : r.from) sum += out[p];
    out[r.pixel] = sum / static_cast<float>(r.from.size());
  }
}

}  // namespace

std::vector<Replacement> replacements(const std::vector<std::uint8_t>& bad, int width, int height) {
  std::vector<Replacement> list;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto place = [width](int r, int c) { return static_cast<std::uint32_t>(r) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(c); };
      if (bad[place(row, column)] == 0) continue;
      Replacement& replacement = list.emplace_back(Replacement{place(row, column), {}});
      for (int reach = 1; reach <= std::max(width, height) && replacement.from.empty(); ++reach)
        for (int r = std::max(row - reach, 0); r <= std::min(row + reach, height - 1); ++r)
          for (int c = std::max(column - reach, 0); c <= std::min(column + reach, width - 1); ++c)
            if (bad[place(r, c)] == 0) replacement.from.push_back(place(r, c));
    }
  return list;
}

double reference_level(const FrameStatistics& reference) { return median(reference.mean); }

void correct_offsets(const FrameStatistics& reference, Correction& correction) {
  correction.width = reference.width;
  correction.height = reference.height;
  const double level = reference_level(reference);
  correction.gain.assign(reference.mean.size(), 1);
  correction.offset.resize(reference.mean.size());
  for (std::size_t i = 0; i < reference.mean.size(); ++i) correction.offset[i] = static_cast<float>(level - static_cast<double>(reference.mean[i]));
}

void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction) {
  if (cold.width != warm.width || cold.height != warm.height)
    throw InputError(
        fmt::format("the two references have {} x {} and {} x {} pixels; film both with the same window", cold.width, cold.height, warm.width, warm.height));
  const double low = reference_level(cold), step = reference_level(warm) - low;
  if (!(std::abs(step) > 0)) throw InputError("the two references show the same level, so gains cannot be found; film them at different temperatures");
  correct_offsets(cold, correction);
  constexpr double least_answer = 0.1;  // of the median pixel's
  for (std::size_t i = 0; i < cold.mean.size(); ++i) {
    const double answer = (static_cast<double>(warm.mean[i]) - static_cast<double>(cold.mean[i])) / step;
    const double gain = answer > least_answer ? 1 / answer : 1;
    correction.gain[i] = static_cast<float>(gain);
    // Of the rounded gain, so that the cold reference is met exactly.
    correction.offset[i] = static_cast<float>(low - static_cast<double>(correction.gain[i]) * static_cast<double>(cold.mean[i]));
  }
}

void apply(const Correction& correction, const FrameBlock& in, std::vector<float>& out) {
  const std::size_t n = static_cast<std::size_t>(correction.width) * static_cast<std::size_t>(correction.height);
  const std::size_t pixels = in.level.empty() ? in.value.size() : in.level.size();
  const auto fits = [n](const auto& array) { return array.empty() || array.size() == n; };
  if (pixels != n * in.frames || !fits(correction.gain) || correction.gain.size() != correction.offset.size() || !fits(correction.reference) ||
      !fits(correction.mask))
    throw InputError(fmt::format("the correction is for frames of {} x {} pixels and the film has others; give reference films of the same size",
                                 correction.width, correction.height));
  out.resize(pixels);
  for (std::size_t f = 0; f < in.frames; ++f) {
    float* frame = out.data() + f * n;
    if (in.level.empty()) take_levels(correction, in.value.data() + f * n, frame, n);
    else take_levels(correction, in.level.data() + f * n, frame, n);
    if (correction.curve.temperature.size() >= 2) to_temperature(correction.curve, frame, n);
    replace_bad(correction.bad, frame);
    for (std::size_t i = 0; i < correction.reference.size(); ++i) frame[i] -= correction.reference[i];
    for (std::size_t i = 0; i < correction.mask.size(); ++i) frame[i] = correction.mask[i] != 0 ? frame[i] : 0;
  }
}

CorrectedFilm::CorrectedFilm(FilmSource& film, const Correction& correction) : film_(film), correction_(correction), info_(film.info()) {
  info_.floating = true;
  if (!correction.curve.temperature.empty()) info_.quantity = FilmQuantity::kelvin;
}

void CorrectedFilm::read(std::int64_t first, std::size_t count, FrameBlock& block) {
  film_.read(first, count, part_);
  block.first = first;
  block.frames = count;
  block.level.clear();
  apply(correction_, part_, block.value);
}

}  // namespace arenite::thermography
