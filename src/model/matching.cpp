#include "model/matching.hpp"

#include <numeric>
#include <unordered_map>

namespace arenite {

std::vector<std::int32_t> places_in(const std::vector<std::int64_t>& others, const std::vector<std::int64_t>& ids) {
  std::vector<std::int32_t> places(ids.size());
  if (others == ids) {
    std::iota(places.begin(), places.end(), 0);
    return places;
  }
  std::unordered_map<std::int64_t, std::int32_t> place_of;
  for (std::size_t g = 0; g < others.size(); ++g) place_of.emplace(others[g], static_cast<std::int32_t>(g));
  for (std::size_t g = 0; g < ids.size(); ++g) {
    const auto at = place_of.find(ids[g]);
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
