#include "grains/texture/force_scale.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace arenite::texture {
namespace {

/// Contacts between grains that push.
struct Pushes {
  double sum = 0;
  std::size_t count = 0;

  template <int D> void add(const ContactsIn<D>& contacts, const std::vector<std::uint8_t>& doubtful = {}) {
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (contacts.fn[c] > 0 && !contacts.is_wall(c) && (doubtful.empty() || !doubtful[c]))
        sum += contacts.fn[c], ++count;
  }
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

}  // namespace

template <int D>
ForceScale force_scale(const ContactsIn<D>& contacts, double measured, const std::vector<std::uint8_t>& doubtful) {
  constexpr double trace = 1e-3;  // of the mean
  Pushes pushes;
  if (!(measured > 0)) pushes.add(contacts, doubtful);
  const double mean = measured > 0 ? measured : pushes.mean();
  return {mean, -trace * mean};
}

template ForceScale force_scale(const ContactsIn<2>&, double, const std::vector<std::uint8_t>&);
template ForceScale force_scale(const ContactsIn<3>&, double, const std::vector<std::uint8_t>&);

template <int D> double mean_push(const std::vector<const ContactsIn<D>*>& states) {
  Pushes pushes;
  for (const ContactsIn<D>* state : states) pushes.add(*state);
  return pushes.mean();
}

template double mean_push(const std::vector<const Contacts*>&);
template double mean_push(const std::vector<const ContactsIn<3>*>&);

template <int D> bool has_forces(const ContactsIn<D>& contacts) {
  const auto acts = [](const auto& force) { return force != std::remove_cvref_t<decltype(force)>{}; };
  return std::ranges::any_of(contacts.fn, acts) || std::ranges::any_of(contacts.ft, acts);
}

template bool has_forces(const Contacts&);
template bool has_forces(const ContactsIn<3>&);

}  // namespace arenite::texture
