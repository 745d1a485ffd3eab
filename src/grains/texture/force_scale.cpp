#include "grains/texture/force_scale.hpp"

namespace arenite::texture {
namespace {

double mean_push(const Contacts& contacts, const std::vector<std::uint8_t>& doubtful) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < contacts.fn.size(); ++c)
    if (contacts.fn[c] > 0 && (doubtful.empty() || !doubtful[c])) sum += contacts.fn[c], ++count;
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

ForceScale force_scale(const Contacts& contacts, double measured, const std::vector<std::uint8_t>& doubtful) {
  constexpr double trace = 1e-3;  // of the mean
  const double mean = measured > 0 ? measured : mean_push(contacts, doubtful);
  return {mean, -trace * mean};
}

double mean_push(const std::vector<const Contacts*>& states) {
  double sum = 0;
  std::size_t count = 0;
  for (const Contacts* state : states)
    for (const double force : state->fn)
      if (force > 0) sum += force, ++count;
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace arenite::texture
