#include "grains/texture/force_level.hpp"

#include <cmath>
#include <vector>

#include "grains/texture/view.hpp"

namespace arenite::texture {

ForceLevel force_level(const Packing& packing, double number_error) {
  const Contacts& contacts = packing.contacts;
  Options whole;
  whole.border = 0;
  const View view(packing, whole);
  Items between;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c)) between.push_back(c);
  ForceLevel level{between.size(), {}, {}};
  if (between.size() < 2) return level;
  const auto both = jackknife(between, view.contact_block, [&](const Items& some) {
    double mean = 0, above = 0;
    for (const std::size_t c : some) mean += contacts.fn[c] / static_cast<double>(some.size());
    for (const std::size_t c : some) above += contacts.fn[c] > mean;
    return std::vector<double>{mean, above / static_cast<double>(some.size())};
  });
  const double counted = both[0].value * number_error / static_cast<double>(between.size());
  level.mean = {both[0].value, std::hypot(both[0].error, counted)};
  level.above_mean = both[1];
  return level;
}

}  // namespace arenite::texture
