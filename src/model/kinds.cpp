#include "model/kinds.hpp"

namespace arenite {

NodeKind kind_of(GrainClass of_grain) {
  return static_cast<NodeKind>(static_cast<int>(NodeKind::grain) + static_cast<int>(of_grain));
}

NodeKind kind_of(const PhaseMap& map, std::size_t node) {
  if (map.phase[node] != Phase::particle) return static_cast<NodeKind>(map.phase[node]);
  const std::int32_t grain = map.grain[node];
  if (grain < 0 || map.grain_class.empty()) return NodeKind::grain;
  return kind_of(map.grain_class[static_cast<std::size_t>(grain)]);
}

std::vector<NodeKind> kinds_of(const PhaseMap& map) {
  std::vector<NodeKind> kinds(map.size());
  for (std::size_t node = 0; node < kinds.size(); ++node) kinds[node] = kind_of(map, node);
  return kinds;
}

}  // namespace arenite
