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

}  // namespace arenite
