#include "grains/fields/coarse_grained.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/problems.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/texture/view.hpp"
#include "model/periodic_images.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;
using std::numbers::pi;

constexpr double gaussian_reach = 8.5;             // exp(-8.5^2/2) = 2.1e-16
constexpr double lucy_reach = 3.3466401061363023;  // sqrt(56/5): <x^2> = 5 c^2/56

/// Integral from 0 to t of 1 - 6 q^2 + 8 q^3 - 3 q^4 = (1 + 3 q)(1 - q)^3 with q^2 = p^2 + t^2: lengths in c.
double lucy_primitive(double p, double t) {
  const double p2 = p * p, t2 = t * t, r = std::sqrt(p2 + t2);
  const double squares = t * (p2 + t2 / 3), fourths = t * (p2 * p2 + t2 * (2 * p2 / 3 + t2 / 5));
  const double cubes = t * r * (r * r / 4 + 3 * p2 / 8) + (p2 > 0 ? 3 * p2 * p2 / 8 * std::asinh(t / p) : 0.0);
  return t - 6 * squares + 8 * cubes - 3 * fourths;
}

/// Integral of Lucy's function along the line at distance p from the centre, from t0 to t1; zero outside the unit
/// circle.
double lucy_along(double p, double t0, double t1) {
  if (p >= 1) return 0;
  const double chord = std::sqrt(1 - p * p);
  const double from = std::clamp(t0, -chord, chord), to = std::clamp(t1, -chord, chord);
  return from < to ? 5 / pi * (lucy_primitive(p, to) - lucy_primitive(p, from)) : 0.0;
}

/// The same of the Gaussian of width 1, zero where the line lies beyond its reach.
double gaussian_along(double p, double t0, double t1) {
  if (p > gaussian_reach || t0 > gaussian_reach || t1 < -gaussian_reach) return 0;
  constexpr double root = std::numbers::sqrt2 / 2;
  return std::exp(-0.5 * p * p) / std::sqrt(8 * pi) * (std::erf(root * t1) - std::erf(root * t0));
}

/// Calls visit(index, point) for the points of a grid in a rectangle.
template <class Visit> void for_points_in(const Grid& grid, const geometry::Rectangle& part, Visit&& visit) {
  const auto first = [](double low, double origin, double step, int count) {
    return static_cast<int>(std::clamp(std::ceil((low - origin) / step - 0.5), 0.0, static_cast<double>(count)));
  };
  const double dx = grid.bounds.width() / grid.columns, dy = grid.bounds.height() / grid.rows;
  const int column0 = first(part.x_min, grid.bounds.x_min, dx, grid.columns),
            column1 = first(part.x_max, grid.bounds.x_min, dx, grid.columns);
  const int row0 = first(part.y_min, grid.bounds.y_min, dy, grid.rows),
            row1 = first(part.y_max, grid.bounds.y_min, dy, grid.rows);
  for (int row = row0; row < row1; ++row)
    for (int column = column0; column < column1; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column),
            grid.point(column, row));
}

/// How fast an image of the cell moves against the cell itself.
Vec2 image_velocity(const Domain& domain, const CoarseGraining& choice, const ImageShift& image) {
  const auto rate = [&](int low, int high) { return domain.wall[high].velocity - domain.wall[low].velocity; };
  const double wider = domain.periodic[0] ? rate(left, right) : 0, higher = domain.periodic[1] ? rate(bottom, top) : 0;
  const double tilting = choice.tilt_rate.value_or(domain.periodic[0] ? domain.tilt * wider / domain.width() : 0);
  return {image.columns * wider + image.rows * tilting, image.rows * higher};
}

/// Calls visit(index, vector from the grain's image to the point, the image's velocity) for every grid point that the
/// kernel reaches.
template <class Visit>
void for_points_near(const Packing& packing, std::size_t g, const Grid& grid, const CoarseGraining& choice,
                     double reach, Visit&& visit) {
  const Grains& grains = packing.grains;
  const geometry::Rectangle extent = geometry::square_about(grains.position[g], reach);
  for_each_image(packing.domain, extent, grid.bounds, [&](const ImageShift& image) {
    const Vec2 centre = grains.position[g] + image.shift;
    const Vec2 velocity = grains.velocity[g] + image_velocity(packing.domain, choice, image);
    for_points_in(grid, extent + image.shift, [&](std::size_t k, Vec2 point) {
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
    const double mass = mass_of(packing, g) / length, area = pi * grains.radius[g] * grains.radius[g];
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

/// V at the places of the grains, m/s.
std::vector<Vec2> velocity_at_grains(const Packing& packing, const CoarseGraining& choice, const Kernel& kernel) {
  const Grains& grains = packing.grains;
  std::vector<Vec2> momentum(grains.size());
  std::vector<double> density(grains.size(), 0.0);
  if (grains.size() == 0) return momentum;
  const geometry::PointGrid near(grains.position, kernel.reach());
  const geometry::Rectangle around = geometry::bounds(grains.position);
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const geometry::Rectangle extent = geometry::square_about(grains.position[g], kernel.reach());
    for_each_image(packing.domain, extent, around, [&](const ImageShift& image) {
      const Vec2 centre = grains.position[g] + image.shift;
      const Vec2 velocity = grains.velocity[g] + image_velocity(packing.domain, choice, image);
      near.within(centre, kernel.reach(), [&](std::int32_t other, double) {
        const double weight = mass_of(packing, g) * kernel.value(grains.position[other] - centre);
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
void add_kinetic_stress(const Packing& packing, const CoarseGraining& choice, const Kernel& kernel,
                        CoarseFields& fields) {
  const std::vector<Vec2> around = velocity_at_grains(packing, choice, kernel);
  for (std::size_t g = 0; g < packing.grains.size(); ++g) {
    const double mass = mass_of(packing, g) / packing.domain.thickness;
    const Vec2 fluctuation = packing.grains.velocity[g] - around[g];
    const Tensor2 own = outer(fluctuation, fluctuation);
    for_points_near(packing, g, fields.grid, choice, kernel.reach(), [&](std::size_t k, Vec2 d, Vec2 velocity) {
      if (!(fields.density[k] > 0)) return;
      const Vec2 apart = velocity - fields.velocity[k];
      const double weight = -mass * kernel.value(d);
      fields.kinetic_stress[k] += weight * own;
      fields.gradient_stress[k] += weight * outer(apart, apart);
      fields.gradient_stress[k] += -weight * own;
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
    const geometry::Rectangle extent =
        geometry::bounds(std::array{start, start + branch}, std::array{kernel.reach(), kernel.reach()});
    for_each_image(packing.domain, extent, fields.grid.bounds, [&](const ImageShift& image) {
      for_points_in(fields.grid, extent + image.shift, [&](std::size_t k, Vec2 point) {
        const Vec2 from = point - start - image.shift, to = from - branch;
        fields.contact_stress[k] += kernel.line_mean(from, to) * moment;
        if (contacts.is_wall(c)) fields.wall_force[k] += kernel.value(to) * force;
      });
    });
  }
}

void check(const Packing& packing, const Grid& grid) {
  const Domain& domain = packing.domain;
  if (!(domain.width() > 0 && domain.height() > 0))
    throw InputError("the box is not known; coarse-grained fields need its size");
  if (!(domain.thickness > 0))
    throw refusal("a thickness of {:g} m; coarse-grained fields need a positive one", domain.thickness);
  if (grid.columns < 1 || grid.rows < 1 || !(grid.bounds.width() > 0 && grid.bounds.height() > 0))
    throw refusal("a grid of {} x {} points over {:g} m x {:g} m; give at least one point and a positive area",
                  grid.columns, grid.rows, grid.bounds.width(), grid.bounds.height());
}

}  // namespace

Kernel::Kernel(KernelShape shape, double width)
    : shape_(shape),
      width_(width),
      reach_(width * (shape == KernelShape::gaussian ? gaussian_reach : lucy_reach)) {
  if (!(width > 0) || !std::isfinite(width))
    throw refusal("a coarse-graining width of {:g} m; give a positive length", width);
}

double Kernel::value(Vec2 d) const {
  if (shape_ == KernelShape::gaussian)
    return std::exp(-0.5 * dot(d, d) / (width_ * width_)) / (2 * pi * width_ * width_);
  const double q = norm(d) / reach_;
  return q < 1 ? 5 / (pi * reach_ * reach_) * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q) : 0;
}

Vec2 Kernel::gradient(Vec2 d) const {
  if (shape_ == KernelShape::gaussian) return -value(d) / (width_ * width_) * d;
  // d/dq (1 + 3 q)(1 - q)^3 = -12 q (1 - q)^2, and grad q = d/(q c^2).
  const double c2 = reach_ * reach_, q = norm(d) / reach_;
  return q < 1 ? -60 / (pi * c2 * c2) * (1 - q) * (1 - q) * d : Vec2{};
}

double Kernel::line_mean(Vec2 from, Vec2 to) const {
  const double length = norm(to - from), unit = shape_ == KernelShape::gaussian ? width_ : reach_;
  if (!(length > 0)) return value(from);
  const Vec2 along = (to - from) / length;
  const double p = std::abs(cross(from, along)) / unit, t0 = dot(from, along) / unit, t1 = dot(to, along) / unit;
  return (shape_ == KernelShape::gaussian ? gaussian_along(p, t0, t1) : lucy_along(p, t0, t1)) / (unit * length);
}

Grid grid_over(const Domain& domain, double spacing) {
  if (!(spacing > 0)) throw refusal("a grid of spacing {:g} m; give a positive length", spacing);
  const auto cells = [&](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / spacing * (1 - 1e-12))));
  };
  return {box_of(domain), cells(domain.width()), cells(domain.height())};
}

std::vector<double> Grid::lines_x() const {
  std::vector<double> x;
  for (int c = 0; c < columns; ++c) x.push_back(point(c, 0).x);
  return x;
}

std::vector<double> Grid::lines_y() const {
  std::vector<double> y;
  for (int r = 0; r < rows; ++r) y.push_back(point(0, r).y);
  return y;
}

void declare(ParameterVisitor& v, CoarseGraining& choice) {
  v.number({"width", "Standard deviation of the kernel along one axis.", true}, choice.width, "m", range::positive);
  v.number({"spacing", "Distance between the points; unless given, the width."}, choice.spacing, "m", range::positive);
  v.choice({"kernel", "What a point is smeared out into."}, choice.kernel,
           {{"lucy", "Lucy's function, zero beyond sqrt(56/5) widths"}, {"gaussian", "Gauss's, which reaches far"}});
  v.number({"tilt_rate", "Rate at which a sheared cell tilts; unless given, its tilt moves with its width alone."},
           choice.tilt_rate, "m/s", range::any);
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
                      std::vector<Tensor2>(n),
                      std::vector<Vec2>(n)};
  add_grains(packing, choice, kernel, fields);
  add_kinetic_stress(packing, choice, kernel, fields);
  add_contacts(packing, kernel, fields);
  return fields;
}

CoarseFields coarse_grain(const Packing& packing, const CoarseGraining& choice) {
  return coarse_grain(packing, grid_over(packing.domain, choice.spacing.value_or(choice.width)), choice);
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

bool has_fields(const Packing& packing) {
  return packing.grains.size() > 0 && packing.domain.width() > 0 && packing.domain.height() > 0 &&
         packing.domain.thickness > 0;
}

CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing) {
  CoarseGraining choice;
  choice.width = width;
  choice.spacing = spacing;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.height();
  return coarse_grain(packing, choice);
}

}  // namespace arenite::fields
