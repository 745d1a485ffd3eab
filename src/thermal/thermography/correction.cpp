#include "thermal/thermography/correction.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "core/problems.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/frame_statistics.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"

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

/// So many numbers that what lies between them is straight to a thousandth of what a camera resolves.
constexpr std::size_t numbers = 8193;

template <class Law> LevelCurve tabulate(const LevelRange& range, Law&& law) {
  LevelCurve curve{range.low, (range.high - range.low) / static_cast<double>(numbers - 1), {}};
  if (!(curve.step > 0))
    throw refusal("levels from {} to {} are not a range for a calibration curve; give a lower and a higher one",
                  range.low, range.high);
  for (std::size_t i = 0; i < numbers; ++i)
    curve.temperature.push_back(static_cast<float>(law(range.low + static_cast<double>(i) * curve.step)));
  return curve;
}

void check(const std::vector<LevelPoint>& points) {
  if (points.size() < 2) throw refusal("a calibration curve of {} points is too short; give 2 or more", points.size());
  for (const LevelPoint& p : points)
    if (!std::isfinite(p.level) || !(p.temperature > 0) || !std::isfinite(p.temperature))
      throw refusal("a calibration curve has the point ({}, {} K), which is impossible; correct it", p.level,
                    p.temperature);
}

}  // namespace

std::vector<Replacement> replacements(const std::vector<std::uint8_t>& bad, int width, int height) {
  std::vector<Replacement> list;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto pixel =
          static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(column);
      if (bad[pixel] == 0) continue;
      Replacement& replacement = list.emplace_back(Replacement{pixel, {}});
      for (int reach = 1; reach <= std::max(width, height) && replacement.from.empty(); ++reach)
        each_pixel_near({static_cast<double>(column), static_cast<double>(row)}, reach, width, height,
                        [&](int, int, std::size_t near) {
                          if (bad[near] == 0) replacement.from.push_back(static_cast<std::uint32_t>(near));
                        });
    }
  return list;
}

double reference_level(const FrameStatistics& reference) { return median_of_finite(reference.mean); }

void correct_offsets(const FrameStatistics& reference, Correction& correction) {
  correction.width = reference.width;
  correction.height = reference.height;
  const double level = reference_level(reference);
  correction.gain.assign(reference.mean.size(), 1);
  correction.offset.resize(reference.mean.size());
  for (std::size_t i = 0; i < reference.mean.size(); ++i)
    correction.offset[i] = static_cast<float>(level - static_cast<double>(reference.mean[i]));
}

void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction) {
  if (cold.width != warm.width || cold.height != warm.height)
    throw refusal("the two references have {} x {} and {} x {} pixels; film both with the same window", cold.width,
                  cold.height, warm.width, warm.height);
  const double low = reference_level(cold), step = reference_level(warm) - low;
  if (!(std::abs(step) > 0))
    throw InputError(
        "the two references show the same level, so gains cannot be found; film them at different temperatures");
  correct_offsets(cold, correction);
  constexpr double least_answer = 0.1;  // of the median pixel's
  for (std::size_t i = 0; i < cold.mean.size(); ++i) {
    const double answer = (static_cast<double>(warm.mean[i]) - static_cast<double>(cold.mean[i])) / step;
    const double gain = answer > least_answer ? 1 / answer : 1;
    correction.gain[i] = static_cast<float>(gain);
    // Of the rounded gain, so that the cold reference is met exactly.
    correction.offset[i] =
        static_cast<float>(low - static_cast<double>(correction.gain[i]) * static_cast<double>(cold.mean[i]));
  }
}

void apply(const Correction& correction, const FrameBlock& in, std::vector<float>& out) {
  const std::size_t n = static_cast<std::size_t>(correction.width) * static_cast<std::size_t>(correction.height);
  const std::size_t pixels = in.level.empty() ? in.value.size() : in.level.size();
  const auto fits = [n](const auto& array) { return array.empty() || array.size() == n; };
  if (pixels != n * in.frames || !fits(correction.gain) || correction.gain.size() != correction.offset.size() ||
      !fits(correction.reference) || !fits(correction.mask))
    throw refusal(
        "the correction is for frames of {} x {} pixels and the film has others; give reference films of the same size",
        correction.width, correction.height);
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

CorrectedFilm::CorrectedFilm(FilmSource& film, const Correction& correction)
    : film_(film),
      correction_(correction),
      info_(film.info()) {
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

LevelCurve curve_through(std::vector<LevelPoint> points, const radiometry::Band& band,
                         const radiometry::Surface& surface, const LevelRange& range) {
  check(points);
  std::sort(points.begin(), points.end(), [](const LevelPoint& a, const LevelPoint& b) { return a.level < b.level; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].level > points[i - 1].level) || !(points[i].temperature > points[i - 1].temperature))
      throw refusal("a calibration curve does not rise from level {} to {}; correct its points", points[i - 1].level,
                    points[i].level);
  std::size_t k = 1;
  return tabulate(range, [&](double level) {
    while (k + 1 < points.size() && level > points[k].level) ++k;
    const LevelPoint &a = points[k - 1], &b = points[k];
    const double t = a.temperature + (level - a.level) * (b.temperature - a.temperature) / (b.level - a.level);
    return surface.emissivity == 1
               ? t
               : radiometry::temperature_of_seen(band, surface, radiometry::photon_exitance(band, t));
  });
}

LevelCurve curve_by_references(const radiometry::Band& band, const LevelPoint& cold, const LevelPoint& warm,
                               const radiometry::Surface& surface, const LevelRange& range) {
  if (!(cold.temperature > 0) || !(warm.temperature > cold.temperature) || cold.level == warm.level)
    throw refusal(
        "references of {} K and {} K at levels {} and {} cannot be used for calibration; film a colder and a warmer "
        "one",
        cold.temperature, warm.temperature, cold.level, warm.level);
  const double low = radiometry::photon_exitance(band, cold.temperature),
               high = radiometry::photon_exitance(band, warm.temperature);
  return tabulate(range, [&](double level) {
    return radiometry::temperature_of_seen(band, surface,
                                           low + (level - cold.level) * (high - low) / (warm.level - cold.level));
  });
}

LevelCurve curve_by_radiometry(const radiometry::Band& band, const LevelPoint& known,
                               const radiometry::Surface& surface, const LevelRange& range) {
  if (!(known.temperature > 0) || !(known.level > 0))
    throw refusal(
        "a level of {} at {} K cannot be used for calibration; give a level above 0 and a temperature above 0 K",
        known.level, known.temperature);
  const double photons = radiometry::photon_exitance(band, known.temperature) / known.level;
  return tabulate(range, [&](double level) { return radiometry::temperature_of_seen(band, surface, photons * level); });
}

void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces) {
  const auto as_assumed = [&](double e) { return e == surfaces.assumed.emissivity; };
  if (std::all_of(surfaces.emissivity.begin(), surfaces.emissivity.end(), as_assumed)) return;
  constexpr double spread = 1.5;  // pixels: how far a lens spreads a rim
  const auto grain = owners(grains, maps.width, maps.height, spread);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const auto material = grain[i] < 0 ? -1 : grains.material[static_cast<std::size_t>(grain[i])];
    if (material < 0 || !std::isfinite(maps.mean[i])) continue;
    const double emissivity = surfaces.emissivity[static_cast<std::size_t>(material)];
    const auto true_one = radiometry::taken_for_another(
        surfaces.band, surfaces.assumed, {emissivity, surfaces.assumed.ambient}, static_cast<double>(maps.mean[i]));
    maps.mean[i] = static_cast<float>(true_one.temperature);
    for (const auto& map : lockin_maps)
      if (auto& values = maps.*map.values; !values.empty() && &values != &maps.mean && &values != &maps.phase)
        values[i] *= static_cast<float>(true_one.factor);
  }
}

}  // namespace arenite::thermography
