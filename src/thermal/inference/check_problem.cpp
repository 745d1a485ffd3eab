#include "thermal/inference/check_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "model/periodic_images.hpp"

namespace arenite::inference {
namespace {

void check_grains(const ForceProblem& problem, Problems& problems) {
  const Packing& packing = problem.packing;
  const Grains& grains = packing.grains;
  if (!(packing.domain.thickness > 0))
    problems.add("the thickness of the sample is not known; give the cylinders' length");
  for (std::size_t g = 0; g < grains.size(); ++g)
    if (!(grains.radius[g] > 0) || !is_finite(grains.position[g])) {
      problems.add("grain {} needs a finite position and a positive radius; correct or remove it", grains.id[g]);
      return;
    }
  const Domain& d = packing.domain;
  for (const geometry::Pair& pair : pairs_within(grains, d, 0)) {
    const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
    if (!problem.is_seen(i) || !problem.is_seen(j)) continue;  // where it is, is known only so far
    const double overlap =
        grains.radius[i] + grains.radius[j] - norm(d.nearest_image(grains.position[i] - grains.position[j]));
    if (overlap > 0.4 * std::min(grains.radius[i], grains.radius[j]))
      problems.add(
          "grains {} and {} overlap by {:.2g} mm, more than a fifth of the smaller diameter; check their centres and "
          "radii",
          grains.id[i], grains.id[j], 1e3 * overlap);
  }
}

void check_contacts(const Packing& packing, Problems& problems) {
  const Contacts& contacts = packing.contacts;
  const auto n = static_cast<std::int32_t>(packing.grains.size());
  if (contacts.size() == 0) problems.add("no contacts are proposed; allow a larger gap between grains");
  std::set<std::pair<int, int>> seen;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::int32_t i = contacts.i[c], j = contacts.j[c];
    if (i < 0 || i >= n || j >= n || is_boundary(j) || i == j)
      problems.add(
          "contact {} joins {} and {}, one of which is neither a grain nor a wall; correct the list of contacts", c, i,
          j);
    else if (!seen.insert({std::min(i, j), std::max(i, j)}).second)
      problems.add("the contact of {} and {} is listed twice; keep one", i, j);
  }
}

void check_factors(const ForceProblem& problem, Problems& problems) {
  std::set<std::int32_t> reported;
  for (const std::int32_t m : problem.packing.grains.material) {
    const auto index = static_cast<std::size_t>(std::max(0, m));
    const bool known =
        m >= 0 && index < problem.factor.size() && std::isfinite(problem.factor[index]) && problem.factor[index] != 0;
    if (known || !reported.insert(m).second) continue;
    const bool named = m >= 0 && index < problem.packing.materials.size();
    problems.add("material {} has no thermoelastic factor; give thermoelastic_factor, e.g. \"0.0150 K/MPa\"",
                 named ? problem.packing.materials[index].name : std::to_string(m));
  }
}

void check_walls(const ForceProblem& problem, Problems& problems) {
  const Contacts& contacts = problem.packing.contacts;
  for (const WallLoad& wall : problem.walls) {
    if (wall.side < 0 || wall.side > 3 || !std::isfinite(wall.force) || !(wall.error > 0)) {
      problems.add("a wall load needs a side, a finite force and a positive error");
      continue;
    }
    bool touched = false;
    for (std::size_t c = 0; c < contacts.size(); ++c)
      touched |= contacts.is_wall(c) && contacts.wall_side(c) == wall.side;
    if (!touched)
      problems.add("the {} wall carries a load, but no contact with it is proposed; check the positions of the walls",
                   side_names[static_cast<std::size_t>(wall.side)]);
  }
}

void check_options(const ForceOptions& o, Problems& problems) {
  const auto at_least = [&](const char* name, double value, double least, bool equal) {
    if (!std::isfinite(value) || value < least || (!equal && value == least))
      problems.add("{} is {}; it must be {} {}", name, value, equal ? "at least" : "above", least);
  };
  at_least("blur", o.blur, 0, true), at_least("rim_margin", o.rim_margin, 0, true),
      at_least("contact_margin", o.contact_margin, 0, true);
  at_least("model_error", o.model_error, 0, true), at_least("position_error", o.position_error, 0, true);
  at_least("balance_error", o.balance_error, 0, false), at_least("prior", o.prior, 0, true);
  at_least("iterations", o.iterations, 1, true);
  if (o.inequality == Inequality::cone) at_least("friction", o.friction, 0, false);
}

}  // namespace

void check_problem(const ForceProblem& problem, const ForceOptions& options, bool factors) {
  Problems problems;
  check_options(options, problems);
  check_grains(problem, problems);
  check_contacts(problem.packing, problems);
  check_walls(problem, problems);
  if (factors) check_factors(problem, problems);
  problems.raise();
}

}  // namespace arenite::inference
