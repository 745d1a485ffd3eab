#include "thermal/imaging/proposed_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/problems.hpp"
#include "model/periodic_images.hpp"

namespace arenite::imaging {
namespace {

void check_errors(const std::vector<double>& errors, std::size_t grains, const char* name) {
  if (!errors.empty() && errors.size() != grains)
    throw refusal("there are {} errors of the {} for {} grains; give one per grain", errors.size(), name, grains);
  if (!std::all_of(errors.begin(), errors.end(), [](double e) { return std::isfinite(e) && e >= 0; }))
    throw refusal("errors of the {} must be numbers of at least 0", name);
}

template <int D> void check(const GrainsIn<D>& grains, const GrainErrors& errors, const ContactTolerance& tolerance) {
  for (std::size_t g = 0; g < grains.size(); ++g)
    if (!is_finite(grains.position[g]) || !(grains.radius[g] > 0) || !std::isfinite(grains.radius[g]))
      throw refusal("grain {} has no position or no positive radius", grains.id[g]);
  check_errors(errors.position, grains.size(), "position");
  check_errors(errors.radius, grains.size(), "radius");
  for (const double v : {tolerance.errors, tolerance.floor, tolerance.pixel, tolerance.wall_error})
    if (!std::isfinite(v) || v < 0) throw InputError("the tolerances of proposed contacts must be at least 0");
}

/// Standard error of where a grain's surface is, along a line through its centre.
double surface_error(const GrainErrors& errors, std::size_t g) {
  return std::hypot(errors.position.empty() ? 0.0 : errors.position[g], errors.radius.empty() ? 0.0 : errors.radius[g]);
}

}  // namespace

template <int D>
ContactsIn<D> propose_contacts(const GrainsIn<D>& grains, const std::type_identity_t<DomainIn<D>>& domain,
                               const GrainErrors& errors, const ContactTolerance& tolerance) {
  check(grains, errors, tolerance);
  const double floor = tolerance.floor * tolerance.pixel;
  double largest = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) largest = std::max(largest, surface_error(errors, g));
  ContactsIn<D> contacts;
  for (const auto& [i, j] : pairs_within(grains, domain, floor + tolerance.errors * std::sqrt(2.0) * largest)) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const Vec<D> branch = domain.nearest_image(grains.position[a] - grains.position[b]);
    const double distance = norm(branch), overlap = grains.radius[a] + grains.radius[b] - distance;
    const double error = std::hypot(surface_error(errors, a), surface_error(errors, b));
    if (-overlap > floor + tolerance.errors * error || !(distance > 0)) continue;
    contacts.add(i, j, (1 / distance) * branch, 0, {}, grains.radius[a] - 0.5 * overlap,
                 grains.radius[b] - 0.5 * overlap);
    contacts.overlap.back() = overlap;
  }
  for (int side = 0; side < sides_in<D>; ++side) {
    if (!domain.wall[static_cast<std::size_t>(side)].present) continue;
    for (std::size_t g = 0; g < grains.size(); ++g) {
      const double distance = domain.depth(side, grains.position[g]);
      const double error = std::hypot(surface_error(errors, g), tolerance.wall_error);
      if (distance - grains.radius[g] > floor + tolerance.errors * error) continue;
      contacts.add(static_cast<std::int32_t>(g), wall_partner(side), inward_normal<D>(side), 0, {}, distance, 0);
      contacts.overlap.back() = grains.radius[g] - distance;
    }
  }
  return contacts;
}

template Contacts propose_contacts<2>(const Grains&, const Domain&, const GrainErrors&, const ContactTolerance&);
template ContactsIn<3> propose_contacts<3>(const GrainsIn<3>&, const DomainIn<3>&, const GrainErrors&,
                                           const ContactTolerance&);

}  // namespace arenite::imaging
