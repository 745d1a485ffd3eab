#include "grains/fields/coarse_grained.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"
#include "grains/texture/view.hpp"
#include "model/periodic_images.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;

/// Calls visit(index, point) for the points of a grid in a rectangle.
template <class Visit> void for_points_in(const Grid& grid, const geometry::Rectangle& part, Visit&& visit) {
  const auto first = [](double low, double origin, double step, int count) {
    return static_cast<int>(std::clamp(std::ceil((low - origin) / step - 0.5), 0.0, static_cast<double>(count)));
  };
  const double dx = grid.bounds.width() / grid.columns, dy = grid.bounds.height() / grid.rows;
  const int column0 = first(part.x_min, grid.bounds.x_min, dx, grid.columns), column1 = first(part.x_max, grid.bounds.x_min, dx, grid.columns);
  const int row0 = first(part.y_min, grid.bounds.y_min, dy, grid.rows), row1 = first(part.y_max, grid.bounds.y_min, dy, grid.rows);
  for (int row = row0; row < row1; ++row)
    for (int column = column0; column < column1; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column), grid.point(column, row));
}

/// Rectangle around a line from a to b, wider by `reach` on every side.
geometry::Rectangle around(Vec2 a, Vec2 b, double reach) {
  return {std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach};
}

geometry::Rectangle moved(const geometry::Rectangle& r, Vec2 by) { return {r.x_min + by.x, r.x_max + by.x, r.y_min + by.y, r.y_max + by.y}; }

/// How fast an image of the cell moves against the cell itself.
Vec2 image_velocity(const Domain& domain, const CoarseGraining& choice, const ImageShift& image) {
  const auto rate = [&](int low, int high) { return domain.wall[high].velocity - domain.wall[low].velocity; };
  const double wider = domain.periodic[0] ? rate(left, right) : 0, higher = domain.periodic[1] ? rate(bottom, top) : 0;
  const double tilting = choice.tilt_rate.value_or(domain.periodic[0] ? domain.tilt * wider / domain.width() : 0);
  return {image.columns * wider + image.rows * tilting, image.rows * higher};
}

/// Calls visit(index, vector from the grain's image to the point, the image's velocity) for every grid point that the kernel reaches.
template <class Visit>
void for_points_near(const Packing& packing, std::size_t g, const Grid& grid, const CoarseGraining& choice, double reach, Visit&& visit) {
  const Grains& grains = packing.grains;
  const geometry::Rectangle extent = around(grains.position[g], grains.position[g], reach);
  for_each_image(packing.domain, extent, grid.bounds, [&](const ImageShift& image) {
    const Vec2 centre = grains.position[g] + image.shift;
    const Vec2 velocity = grains.velocity[g] + image_velocity(packing.domain, choice, image);
    for_points_in(grid, moved(extent, image.shift), [&](std::size_t k, Vec2 point) {
      if (const Vec2 d = point - centre; dot(d, d) < reach * reach) visit(k, d, velocity);
    });
  });
}

/// Density, momentum, and the velocity with its gradient, grad V = (grad p - V (x) grad rho)/rho.
void add_grains(const Packing& packing, const CoarseGraining& choice, const Kernel& kernel, CoarseFields& fields) {
  const Grains& grains = packing.grains;
  const double length = packing.domain.thickness;
  std::vector<Vec2> density_gradient(fields.grid.size());
  std::vector<Tensor2> momentum_gradient(fields.grid.size());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double mass = texture::mass_of(packing, g) / length, area = std::numbers::pi * grains.radius[g] * grains.radius[g];
    for_points_near(packing, g, fields.grid, choice, kernel.reach(), [&](std::size_t k, Vec2 d, Vec2 velocity) {
      const double phi = kernel.value(d);
      const Vec2 slope = mass * kernel.gradient(d);
      fields.density[k] += mass * phi;
      fields.solid_fraction[k] += area * phi;
      fields.momentum[k] += mass * phi * velocity;
      density_gradient[k] += slope;
      momentum_gradient[k] += outer(velocity, slope);
    });
  }
  for (std::size_t k = 0; k < fields.grid.size(); ++k) {
    if (!(fields.density[k] > 0)) continue;
    const Vec2 v = fields.velocity[k] = fields.momentum[k] / fields.density[k];
    Tensor2 slope = momentum_gradient[k];
    slope += -1 * outer(v, density_gradient[k]);
    fields.velocity_gradient[k] = 1 / fields.density[k] * slope;
  }
}

/// In a second pass, when V is known everywhere: a difference of two large sums would lose the fluctuation of a fast flow.
void add_kinetic_stress(const Packing& packing, const CoarseGraining& choice, const Kernel& kernel, CoarseFields& fields) {
  for (std::size_t g = 0; g < packing.grains.size(); ++g) {
    const double mass = texture::mass_of(packing, g) / packing.domain.thickness;
    for_points_near(packing, g, fields.grid, choice, kernel.reach(), [&](std::size_t k, Vec2 d, Vec2 velocity) {
      if (!(fields.density[k] > 0)) return;
      const Vec2 fluctuation = velocity - fields.velocity[k];
      fields.kinetic_stress[k] += -mass * kernel.value(d) * outer(fluctuation, fluctuation);
    });
  }
}

void add_contacts(const Packing& packing, const Kernel& kernel, CoarseFields& fields) {
  const Contacts& contacts = packing.contacts;
  const double length = packing.domain.thickness;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 start = packing.grains.position[contacts.i[c]], force = contacts.force_on_i(c) / length;
    const Vec2 branch = contacts.branch(c);
    const Tensor2 moment = outer(force, branch);
    const geometry::Rectangle extent = around(start, start + branch, kernel.reach());
    for_each_image(packing.domain, extent, fields.grid.bounds, [&](const ImageShift& image) {
      for_points_in(fields.grid, moved(extent, image.shift), [&](std::size_t k, Vec2 point) {
        const Vec2 from = point - start - image.shift, to = from - branch;
        fields.contact_stress[k] += kernel.line_mean(from, to) * moment;
        if (contacts.is_wall(c)) fields.wall_force[k] += kernel.value(to) * force;
      });
    });
  }
}

void check(const Packing& packing, const Grid& grid) {
  const Domain& domain = packing.domain;
  if (!(domain.width() > 0 && domain.height() > 0)) throw InputError("the box is not known; coarse-grained fields need its size");
  if (!(domain.thickness > 0)) throw InputError(fmt::format("a thickness of {:g} m; coarse-grained fields need a positive one", domain.thickness));
  if (grid.columns < 1 || grid.rows < 1 || !(grid.bounds.width() > 0 && grid.bounds.height() > 0))
    throw InputError(fmt::format("a grid of {} x {} points over {:g} m x {:g} m; give at least one point and a positive area", grid.columns, grid.rows,
                                 grid.bounds.width(), grid.bounds.height()));
}

}  // namespace

Grid grid_over(const Domain& domain, double spacing) {
  if (!(spacing > 0)) throw InputError(fmt::format("a grid of spacing {:g} m; give a positive length", spacing));
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / spacing * (1 - 1e-12)))); };
  return {texture::box_of(domain), cells(domain.width()), cells(domain.height())};
}

CoarseFields coarse_grain(const Packing& packing, const Grid& grid, const CoarseGraining& choice) {
  check(packing, grid);
  const Kernel kernel(choice.kernel, choice.width);
  const std::size_t n = grid.size();
  CoarseFields fields{grid,
                      std::vector<double>(n),
                      std::vector<double>(n),
                      std::vector<Vec2>(n),
                      std::vector<Vec2>(n, Vec2{unknown, unknown}),
                      std::vector<Tensor2>(n, Tensor2{unknown, unknown, unknown, unknown}),
                      std::vector<Tensor2>(n),
                      std::vector<Tensor2>(n),
                      std::vector<Vec2>(n)};
  add_grains(packing, choice, kernel, fields);
  add_kinetic_stress(packing, choice, kernel, fields);
  add_contacts(packing, kernel, fields);
  return fields;
}

double shear_rate_at(const History& history, double time) {
  const auto *strain = history.find("shear_strain"), *times = history.find("time");
  if (!strain || !times || times->size() < 2) return 0;
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(*times, time) - times->begin(), 1, static_cast<std::ptrdiff_t>(times->size()) - 1);
  const auto k = static_cast<std::size_t>(after);
  const double span = (*times)[k] - (*times)[k - 1];
  return span > 0 ? ((*strain)[k] - (*strain)[k - 1]) / span : 0;
}

double mean_diameter(const Grains& grains) {
  const double sum = std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0);
  return grains.size() == 0 ? 0 : 2 * sum / static_cast<double>(grains.size());
}

bool has_fields(const Packing& packing) {
  return packing.grains.size() > 0 && packing.domain.width() > 0 && packing.domain.height() > 0 && packing.domain.thickness > 0;
}

CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing) {
  CoarseGraining choice;
  choice.width = width;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.height();
  return coarse_grain(packing, grid_over(packing.domain, spacing), choice);
}

}  // namespace arenite::fields
