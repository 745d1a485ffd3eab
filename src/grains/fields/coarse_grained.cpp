#include "grains/fields/coarse_grained.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "core/problems.hpp"
#include "geometry/ball.hpp"
#include "geometry/cell_grid.hpp"
#include "model/joints.hpp"
#include "model/periodic_images.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;

/// What masses and forces are counted by: disks by their length.
double length_through(const Domain& domain) { return domain.thickness; }
double length_through(const Container<3>& /*domain*/) { return 1; }

/// How fast an image of the cell moves against the cell itself.
template <int D>
Vec<D> image_velocity(const Container<D>& domain, const CoarseGraining& choice, const Cells<D>& image) {
  const Vec<D> growth = by_axis<D>([&](int axis) {
    return domain.periodic[axis] ? domain.wall[2 * axis + 1].velocity - domain.wall[2 * axis].velocity : 0;
  });
  const double tilting = choice.tilt_rate.value_or(domain.periodic[0] ? domain.tilt * growth.x / domain.extent(0) : 0);
  Vec<D> velocity = by_axis<D>([&](int axis) { return image[axis] * growth[axis]; });
  velocity.x += image.y * tilting;
  return velocity;
}

/// As far to every side.
template <int D> Vec<D> aside(double reach) {
  return by_axis<D>([&](int) { return reach; });
}

/// Calls visit(index, vector from the grain's image to the point, the image's velocity) for every grid point that the
/// kernel reaches.
template <int D, class Visit>
void for_points_near(const PackingIn<D>& packing, std::size_t g, const GridIn<D>& grid, const CoarseGraining& choice,
                     double reach, Visit&& visit) {
  const GrainsIn<D>& grains = packing.grains;
  const Container<D>& domain = packing.domain;
  const Vec<D> low = grains.position[g] - aside<D>(reach), high = grains.position[g] + aside<D>(reach);
  for_images_between(domain, grid.low - high, grid.high - low, [&](const Cells<D>& image) {
    const Vec<D> shift = domain.way(image), centre = grains.position[g] + shift;
    const Vec<D> velocity = grains.velocity[g] + image_velocity(domain, choice, image);
    for_points_in(grid, low + shift, high + shift, [&](std::size_t k, Vec<D> point) {
      if (const Vec<D> d = point - centre; dot(d, d) < reach * reach) visit(k, d, velocity);
    });
  });
}

/// Density, momentum, and the velocity with its gradient, grad V = (grad p - V (x) grad rho)/rho.
template <int D>
void add_grains(const PackingIn<D>& packing, const CoarseGraining& choice, const KernelIn<D>& kernel,
                CoarseFieldsIn<D>& fields) {
  const GrainsIn<D>& grains = packing.grains;
  const double length = length_through(packing.domain);
  std::vector<Vec<D>> density_gradient(fields.grid.size());
  std::vector<Tensor<D>> momentum_gradient(fields.grid.size());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double mass = mass_of(packing, g) / length, volume = geometry::volume_of_ball<D>(grains.radius[g]);
    for_points_near(packing, g, fields.grid, choice, kernel.reach(), [&](std::size_t k, Vec<D> d, Vec<D> velocity) {
      const double phi = kernel.value(d);
      const Vec<D> slope = mass * kernel.gradient(d);
      fields.density[k] += mass * phi;
      fields.solid_fraction[k] += volume * phi;
      fields.momentum[k] += mass * phi * velocity;
      density_gradient[k] += slope;
      momentum_gradient[k] += outer(velocity, slope);
    });
  }
  for (std::size_t k = 0; k < fields.grid.size(); ++k) {
    if (!(fields.density[k] > 0)) continue;
    const Vec<D> v = fields.velocity[k] = fields.momentum[k] / fields.density[k];
    Tensor<D> slope = momentum_gradient[k];
    slope += -1 * outer(v, density_gradient[k]);
    fields.velocity_gradient[k] = 1 / fields.density[k] * slope;
  }
}

/// V at the places of the grains, m/s.
template <int D>
std::vector<Vec<D>> velocity_at_grains(const PackingIn<D>& packing, const CoarseGraining& choice,
                                       const KernelIn<D>& kernel) {
  const GrainsIn<D>& grains = packing.grains;
  const Container<D>& domain = packing.domain;
  std::vector<Vec<D>> momentum(grains.size());
  std::vector<double> density(grains.size(), 0.0);
  if (grains.size() == 0) return momentum;
  const double reach = kernel.reach();
  Vec<D> low = grains.position[0], high = low;
  for (const Vec<D>& p : grains.position) {
    low = by_axis<D>([&](int axis) { return std::min(low[axis], p[axis]); });
    high = by_axis<D>([&](int axis) { return std::max(high[axis], p[axis]); });
  }
  constexpr std::array most_cells{4096.0, 256.0};  // along a side: 2^24 in all
  const geometry::CellGrid<D> cells({low, high - low, {}}, reach, most_cells[D - 2]);
  const geometry::SortedCells near(cells.size(), 0, grains.size(),
                                   [&](std::size_t g) { return cells.cell(grains.position[g]); });
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const Vec<D> from = grains.position[g] - aside<D>(reach), to = grains.position[g] + aside<D>(reach);
    for_images_between(domain, low - to, high - from, [&](const Cells<D>& image) {
      const Vec<D> centre = grains.position[g] + domain.way(image);
      const Vec<D> velocity = grains.velocity[g] + image_velocity(domain, choice, image);
      near.for_near(cells, centre, [&](std::int32_t other) {
        const Vec<D> away = grains.position[other] - centre;
        if (dot(away, away) > reach * reach) return;
        const double weight = mass_of(packing, g) * kernel.value(away);
        density[other] += weight;
        momentum[other] += weight * velocity;
      });
    });
  }
  for (std::size_t g = 0; g < grains.size(); ++g)
    if (density[g] > 0) momentum[g] = momentum[g] / density[g];
  return momentum;
}

/// In a second pass, when V is known everywhere: a difference of two large sums would lose the fluctuation of a fast
/// flow.
template <int D>
void add_kinetic_stress(const PackingIn<D>& packing, const CoarseGraining& choice, const KernelIn<D>& kernel,
                        CoarseFieldsIn<D>& fields) {
  const std::vector<Vec<D>> around = velocity_at_grains(packing, choice, kernel);
  for (std::size_t g = 0; g < packing.grains.size(); ++g) {
    const double mass = mass_of(packing, g) / length_through(packing.domain);
    const Vec<D> fluctuation = packing.grains.velocity[g] - around[g];
    const Tensor<D> own = outer(fluctuation, fluctuation);
    for_points_near(packing, g, fields.grid, choice, kernel.reach(), [&](std::size_t k, Vec<D> d, Vec<D> velocity) {
      if (!(fields.density[k] > 0)) return;
      const Vec<D> apart = velocity - fields.velocity[k];
      const double weight = -mass * kernel.value(d);
      fields.kinetic_stress[k] += weight * own;
      fields.gradient_stress[k] += weight * outer(apart, apart);
      fields.gradient_stress[k] += -weight * own;
    });
  }
}

/// A force on a grain, and the line from its centre that bears it.
template <int D>
void add_bearing(const Container<D>& domain, const KernelIn<D>& kernel, Vec<D> start, Vec<D> branch, Vec<D> force,
                 bool is_of_wall, CoarseFieldsIn<D>& fields) {
  const Tensor<D> moment = outer(force, branch);
  const typename KernelIn<D>::Line back(-branch);
  const Vec<D> end = start + branch;
  const Vec<D> low = by_axis<D>([&](int axis) { return std::min(start[axis], end[axis]) - kernel.reach(); });
  const Vec<D> high = by_axis<D>([&](int axis) { return std::max(start[axis], end[axis]) + kernel.reach(); });
  for_images_between(domain, fields.grid.low - high, fields.grid.high - low, [&](const Cells<D>& image) {
    const Vec<D> shift = domain.way(image);
    for_points_in(fields.grid, low + shift, high + shift, [&](std::size_t k, Vec<D> point) {
      const Vec<D> from = point - start - shift;
      if (const double mean = kernel.line_mean(from, back); mean != 0) fields.contact_stress[k] += mean * moment;
      if (is_of_wall) fields.wall_force[k] += kernel.value(from - branch) * force;
    });
  });
}

template <int D> void add_contacts(const PackingIn<D>& packing, const KernelIn<D>& kernel, CoarseFieldsIn<D>& fields) {
  const ContactsIn<D>& contacts = packing.contacts;
  const double length = length_through(packing.domain);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    add_bearing<D>(packing.domain, kernel, packing.grains.position[contacts.i[c]], contacts.branch(c),
                   contacts.force_on_i(c) / length, contacts.is_wall(c), fields);
  for_each_joint(packing, [&](std::size_t i, std::size_t, Vec<D> force, Vec<D> way) {
    add_bearing<D>(packing.domain, kernel, packing.grains.position[i], -way, force / length, false, fields);
  });
}

/// "3 x 4", in space "3 x 4 x 5".
template <int D, class Of> std::string along_axes(const Of& of) {
  std::string text;
  for (int axis = 0; axis < D; ++axis) text += (axis > 0 ? " x " : "") + of(axis);
  return text;
}

template <int D> bool has_extent(const Container<D>& domain) {
  bool has = true;
  for (int axis = 0; axis < D; ++axis) has = has && domain.extent(axis) > 0;
  return has;
}

template <int D> void check(const PackingIn<D>& packing, const GridIn<D>& grid) {
  if (!has_extent<D>(packing.domain)) throw InputError("the box is not known; coarse-grained fields need its size");
  if (const double length = length_through(packing.domain); !(length > 0))
    throw refusal("a thickness of {:g} m; coarse-grained fields need a positive one", length);
  bool has_points = true;
  for (int axis = 0; axis < D; ++axis) has_points = has_points && grid.count[axis] >= 1 && grid.extent(axis) > 0;
  if (!has_points)
    throw refusal("a grid of {} points over {}; give at least one point along each axis, and positive lengths",
                  along_axes<D>([&](int axis) { return fmt::format("{}", grid.count[axis]); }),
                  along_axes<D>([&](int axis) { return fmt::format("{:g} m", grid.extent(axis)); }));
}

}  // namespace

template <int D> GridIn<D> grid_over(const Container<D>& domain, double spacing) {
  if (!(spacing > 0)) throw refusal("a grid of spacing {:g} m; give a positive length", spacing);
  const Vec<D> cells =
      by_axis<D>([&](int axis) { return std::max(1.0, std::ceil(domain.extent(axis) / spacing * (1 - 1e-12))); });
  double points = 1, volume = 1;
  for (int axis = 0; axis < D; ++axis) points *= cells[axis], volume *= domain.extent(axis);
  if (const double most = most_points[D - 2]; points > most)
    throw refusal("points {:g} m apart are {:.2g} in this box, and at most {:g} fit; give a spacing above {:.2g} m",
                  spacing, points, most, geometry::side_of_cube<D>(volume / most));
  return {domain.corner(), domain.corner(1),
          by_axis<D>([&](int axis) { return static_cast<std::int32_t>(cells[axis]); })};
}

void declare(ParameterVisitor& v, CoarseGraining& choice) {
  v.number({"width", "Standard deviation of the kernel along one axis.", true}, choice.width, "m", range::positive);
  v.number({"spacing", "Distance between the points; unless given, the width."}, choice.spacing, "m", range::positive);
  v.choice({"kernel", "What a point is smeared out into."}, choice.kernel,
           {{"lucy", "Lucy's function, zero beyond sqrt(56/5) widths"}, {"gaussian", "Gauss's, which reaches far"}});
  v.number({"tilt_rate", "Rate at which a sheared cell tilts; unless given, its tilt moves with its width alone."},
           choice.tilt_rate, "m/s", range::any);
}

template <int D>
CoarseFieldsIn<D> coarse_grain(const PackingIn<D>& packing, const std::type_identity_t<GridIn<D>>& grid,
                               const CoarseGraining& choice) {
  check<D>(packing, grid);
  const KernelIn<D> kernel(choice.kernel, choice.width);
  const std::size_t n = grid.size();
  const Vec<D> nowhere = aside<D>(unknown);
  CoarseFieldsIn<D> fields{grid,
                           std::vector<double>(n),
                           std::vector<double>(n),
                           std::vector<Vec<D>>(n),
                           std::vector<Vec<D>>(n, nowhere),
                           std::vector<Tensor<D>>(n, outer(nowhere, nowhere)),
                           std::vector<Tensor<D>>(n),
                           std::vector<Tensor<D>>(n),
                           std::vector<Tensor<D>>(n),
                           std::vector<Vec<D>>(n)};
  add_grains(packing, choice, kernel, fields);
  add_kinetic_stress(packing, choice, kernel, fields);
  add_contacts(packing, kernel, fields);
  return fields;
}

template <int D> CoarseFieldsIn<D> coarse_grain(const PackingIn<D>& packing, const CoarseGraining& choice) {
  return coarse_grain<D>(packing, grid_over<D>(packing.domain, choice.spacing.value_or(choice.width)), choice);
}

double shear_rate_at(const History& history, double time) {
  const auto *strain = history.find("shear_strain"), *times = history.find("time");
  if (!strain || !times || times->size() < 2) return 0;
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(*times, time) - times->begin(), 1,
                                                static_cast<std::ptrdiff_t>(times->size()) - 1);
  const auto k = static_cast<std::size_t>(after);
  const double span = (*times)[k] - (*times)[k - 1];
  return span > 0 ? ((*strain)[k] - (*strain)[k - 1]) / span : 0;
}

template <int D> bool has_fields(const PackingIn<D>& packing) {
  return packing.grains.size() > 0 && has_extent<D>(packing.domain) && length_through(packing.domain) > 0;
}

template <int D>
CoarseFieldsIn<D> coarse_fields(const PackingIn<D>& packing, double shear_rate, double width, const GridIn<D>& grid) {
  CoarseGraining choice;
  choice.width = width;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.extent(1);
  return coarse_grain<D>(packing, grid, choice);
}

#define ARENITE_OF(D)                                                                                    \
  template GridIn<D> grid_over(const Container<D>&, double);                                             \
  template CoarseFieldsIn<D> coarse_grain(const PackingIn<D>&, const GridIn<D>&, const CoarseGraining&); \
  template CoarseFieldsIn<D> coarse_grain(const PackingIn<D>&, const CoarseGraining&);                   \
  template bool has_fields(const PackingIn<D>&);                                                         \
  template CoarseFieldsIn<D> coarse_fields(const PackingIn<D>&, double, double, const GridIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::fields
