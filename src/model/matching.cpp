#include "model/matching.hpp"

#include <numeric>
#include <unordered_map>

namespace arenite {

std::vector<std::int32_t> places_in(const Grains& other, const Grains& grains) {
  std::vector<std::int32_t> places(grains.size());
  if (other.id == grains.id) {
    std::iota(places.begin(), places.end(), 0);
    return places;
  }
  std::unordered_map<std::int64_t, std::int32_t> place_of;
  for (std::size_t g = 0; g < other.size(); ++g) place_of.emplace(other.id[g], static_cast<std::int32_t>(g));
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const auto at = place_of.find(grains.id[g]);
    places[g] = at == place_of.end() ? -1 : at->second;
  }
  return places;
}

std::vector<std::size_t> nearest_grains(const std::vector<Vec2>& places, const std::vector<Vec2>& others) {
  std::vector<std::size_t> nearest;
  for (const Vec2 place : places) {
    std::size_t best = 0;
    for (std::size_t j = 1; j < others.size(); ++j)
      if (norm(others[j] - place) < norm(others[best] - place)) best = j;
    nearest.push_back(best);
  }
  return nearest;
}

}  // namespace arenite
