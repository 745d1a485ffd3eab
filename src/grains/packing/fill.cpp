#include "grains/packing/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::packing {
namespace {

double disk_area(const Grains& grains) {
  double area = 0;
  for (const double r : grains.radius) area += std::numbers::pi * r * r;
  return area;
}

}  // namespace

double height_for(const Grains& grains, double width, double solid_fraction) {
  return disk_area(grains) / (solid_fraction * width);
}

RelaxReport fill_at_random(Grains& grains, const Domain& domain, std::uint64_t seed) {
  for (std::size_t i = 0; i < grains.size(); ++i) {
    RandomStream random(seed, Purpose::position, i);
    const double mx = domain.periodic_x ? 0 : grains.radius[i], my = domain.periodic_y ? 0 : grains.radius[i];
    grains.x[i] = random.uniform(domain.wall[left].position + mx, domain.wall[right].position - mx);
    grains.y[i] = random.uniform(domain.wall[bottom].position + my, domain.wall[top].position - my);
  }
  constexpr double densest = 0.9069;  // equal disks in a triangular lattice
  const double asked = disk_area(grains) / domain.area();
  if (asked > densest)
    throw InputError(fmt::format("the grains cover {:.3g} times the area of the frame and cannot fit; take fewer, or leave frame.height out with a packing.solid_fraction of 0.80 or less", asked));
  const auto report = relax(grains, domain);
  if (report.overlap_after > 0.01)
    throw InputError(fmt::format("a random filling at solid fraction {:.3f} jams with overlaps of {:.1f} % of the radii; "
                                 "give it room (packing.solid_fraction of {:.2f} or less, or a larger frame.height) and let a "
                                 "loading stage compact it",
                                 asked, 100 * report.overlap_after, std::min(0.80, std::floor(100 * asked) / 100 - 0.03)));
  return report;
}

double fill_lattice(Grains& grains, const Domain& domain) {
  const double site = 2 * *std::max_element(grains.radius.begin(), grains.radius.end());
  const double rise = site * std::sqrt(3.0) / 2;
  const double room = domain.width() / site * (1 + 1e-12);
  const int full = static_cast<int>(room);
  const int shifted = room - full >= 0.5 ? full : full - 1;
  if (full < 1 || (shifted < 1 && grains.size() > 1))
    throw InputError(fmt::format("the frame is {:g} m wide and holds no row of a lattice of {:g} m; widen frame.width", domain.width(), site));
  std::size_t i = 0;
  double y = domain.wall[bottom].position + site / 2;
  for (int row = 0; i < grains.size(); ++row, y += rise) {
    const double x0 = domain.wall[left].position + site * (row % 2 == 0 ? 0.5 : 1.0);
    for (int k = 0; k < (row % 2 == 0 ? full : shifted) && i < grains.size(); ++k, ++i) {
      grains.x[i] = x0 + k * site;
      grains.y[i] = y;
    }
  }
  return y - rise + site / 2 - domain.wall[bottom].position;
}

}  // namespace arenite::packing
