#include "thermal/thermography/nonuniformity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/median.hpp"

namespace arenite::thermography {

double plate_level(const FrameStatistics& plate) { return median(plate.mean); }

void correct_offsets(const FrameStatistics& plate, Correction& correction) {
  correction.width = plate.width;
  correction.height = plate.height;
  const double level = plate_level(plate);
  correction.gain.assign(plate.mean.size(), 1);
  correction.offset.resize(plate.mean.size());
  for (std::size_t i = 0; i < plate.mean.size(); ++i) correction.offset[i] = static_cast<float>(level - static_cast<double>(plate.mean[i]));
}

void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction) {
  if (cold.width != warm.width || cold.height != warm.height)
    throw InputError(fmt::format("the two plates have {} x {} and {} x {} pixels; film both with the same window", cold.width, cold.height,
                                 warm.width, warm.height));
  const double low = plate_level(cold), step = plate_level(warm) - low;
  if (!(std::abs(step) > 0)) throw InputError("the two plates show the same level, so gains cannot be found; film them at different temperatures");
  correct_offsets(cold, correction);
  constexpr double least_answer = 0.1;  // of the median pixel's
  for (std::size_t i = 0; i < cold.mean.size(); ++i) {
    const double answer = (static_cast<double>(warm.mean[i]) - static_cast<double>(cold.mean[i])) / step;
    const double gain = answer > least_answer ? 1 / answer : 1;
    correction.gain[i] = static_cast<float>(gain);
    // Of the rounded gain, so that the cold plate is met exactly.
    correction.offset[i] = static_cast<float>(low - static_cast<double>(correction.gain[i]) * static_cast<double>(cold.mean[i]));
  }
}

}  // namespace arenite::thermography
