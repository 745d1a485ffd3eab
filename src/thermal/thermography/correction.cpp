#include "thermal/thermography/correction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace arenite::thermography {
namespace {

template <class T>
void take_levels(const Correction& c, const T* in, float* out, std::size_t n) {
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
