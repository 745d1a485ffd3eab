#include "grains/dem/integrators/integrators.hpp"

#include <vector>

namespace arenite::dem {

std::string integrators_of_bodies(std::string_view quotes) {
  std::vector<std::string> names;
  for (const Integrator* scheme : integrators)
    if (scheme->moves_bodies) names.push_back(std::string(quotes).append(scheme->word.word).append(quotes));
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) text += (k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

}  // namespace arenite::dem
