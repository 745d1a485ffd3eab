#include "solid/raster/phase_fractions.hpp"

#include <cstdint>

namespace arenite::raster {

PhaseFractions phase_fractions(const PhaseMap& map) {
  std::int64_t phase[3] = {0, 0, 0}, of_class[3] = {0, 0, 0};
  for (std::size_t k = 0; k < map.phase.size(); ++k) {
    ++phase[static_cast<int>(map.phase[k])];
    if (map.phase[k] == Phase::particle) ++of_class[static_cast<int>(map.grain_class[map.grain[k]])];
  }
  if (map.phase.empty()) return {};
  const auto share = [&](std::int64_t n) { return static_cast<double>(n) / static_cast<double>(map.phase.size()); };
  PhaseFractions f;
  f.empty = share(phase[0]), f.matrix = share(phase[1]), f.particle = share(phase[2]);
  f.small = share(of_class[1]), f.large = share(of_class[2]);
  const std::int64_t pores = phase[0] + phase[1];
  f.saturation = pores > 0 ? static_cast<double>(phase[1]) / static_cast<double>(pores) : 0;
  return f;
}

}  // namespace arenite::raster
