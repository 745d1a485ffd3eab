#include "thermal/imaging/label_grains.hpp"

#include <utility>

#include "core/mapped.hpp"

namespace arenite::imaging {
namespace {

std::vector<std::uint8_t> particles_of(const PhaseMap& map) {
  return mapped<std::uint8_t>(map.phase, [](Phase p) { return p == Phase::particle; });
}

}  // namespace

std::vector<std::int32_t> squared_distance(const PhaseMap& map) {
  return geometry::squared_distance({map.width, map.height}, particles_of(map));
}

void label_grains(PhaseMap& map, const LabelOptions& options, bool periodic) {
  auto found = geometry::label_cells({map.width, map.height, 1, periodic}, particles_of(map), options);
  map.grain = std::move(found.label);
  map.grain_class.assign(static_cast<std::size_t>(found.count), GrainClass::none);
}

}  // namespace arenite::imaging
