#include "grains/packing/fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/problems.hpp"
#include "core/random.hpp"
#include "geometry/polygon.hpp"
#include "model/periodic_images.hpp"

namespace arenite::packing {
namespace {

/// Closed boundaries that grains lie around. What encloses more than half of the container holds them, as a drum does.
std::vector<geometry::Polygon> obstacles_of(const DomainIn<3>& /*domain*/) { return {}; }
std::vector<geometry::Polygon> obstacles_of(const Domain& domain) {
  std::vector<geometry::Polygon> obstacles;
  for (const Boundary& boundary : domain.boundaries)
    if (boundary.closed && geometry::area_of(boundary.points) < 0.5 * domain.area())
      obstacles.push_back(boundary.points);
  return obstacles;
}

template <int D> struct Relaxation;

/// Grains inside of an obstacle are pushed out over its nearest side.
void add_obstacle_forces(Relaxation<2>& relaxation);
void add_obstacle_forces(Relaxation<3>& /*relaxation*/) {}

/// Lengths are in units of the mean radius; stiffness and mass are 1.
template <int D> struct Relaxation {
  GrainsIn<D>& grains;
  const DomainIn<D>& domain;
  double unit, skin;
  std::vector<geometry::Polygon> obstacles;
  std::vector<geometry::Pair> pairs;
  std::vector<Vec<D>> force, velocity, listed_at;
  double largest_overlap = 0;

  Relaxation(GrainsIn<D>& g, const DomainIn<D>& d)
      : grains(g),
        domain(d),
        unit(g.mean_diameter() / 2),
        skin(0.3 * unit),
        obstacles(obstacles_of(d)) {
    force.resize(g.size());
    velocity.assign(g.size(), Vec<D>{});
    list_pairs();
  }

  void list_pairs() {
    const geometry::Box<D> box{domain.corner(), domain.size(), domain.periodic};
    pairs = geometry::close_pairs<D>(std::span<const Vec<D>>(grains.position), grains.radius, box, skin);
    listed_at = grains.position;
  }

  bool list_is_stale() const {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const Vec<D> moved = grains.position[i] - listed_at[i];
      if (dot(moved, moved) > 0.25 * skin * skin) return true;
    }
    return false;
  }

  void add_pair_forces() {
    for (const auto [i, j] : pairs) {
      const Vec<D> d = domain.nearest_image(grains.position[i] - grains.position[j]);
      const double reach = grains.radius[i] + grains.radius[j], distance2 = dot(d, d);
      if (distance2 >= reach * reach) continue;
      const double distance = std::sqrt(distance2), overlap = reach - distance;
      // Two centres on one point have no direction; any fixed one parts them.
      const Vec<D> n = distance > 0 ? (1 / distance) * d : inward_normal<D>(left);
      force[i] += (overlap / unit) * n;
      force[j] -= (overlap / unit) * n;
      largest_overlap = std::max(largest_overlap, 2 * overlap / reach);
    }
  }

  void add_wall_forces() {
    for (int side = 0; side < sides_in<D>; ++side) {
      if (domain.is_periodic(side)) continue;
      const Vec<D> n = inward_normal<D>(side);
      for (std::size_t i = 0; i < grains.size(); ++i) {
        const double overlap = grains.radius[i] - domain.depth(side, grains.position[i]);
        if (overlap <= 0) continue;
        force[i] += (overlap / unit) * n;
        largest_overlap = std::max(largest_overlap, overlap / grains.radius[i]);
      }
    }
  }

  void compute_forces() {
    std::fill(force.begin(), force.end(), Vec<D>{});
    largest_overlap = 0;
    add_pair_forces();
    add_wall_forces();
    add_obstacle_forces(*this);
  }

  void move(double dt) {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      velocity[i] += dt * force[i];
      grains.position[i] += unit * dt * velocity[i];
    }
    if (list_is_stale()) {
      wrap();
      list_pairs();
    }
  }

  void wrap() {
    for (Vec<D>& p : grains.position) p = domain.wrapped(p);
  }
};

void add_obstacle_forces(Relaxation<2>& r) {
  for (const geometry::Polygon& obstacle : r.obstacles)
    for (std::size_t i = 0; i < r.grains.size(); ++i) {
      const Vec2 way = geometry::way_from(obstacle, r.grains.position[i]);
      const double outside = norm(way) * (geometry::encloses(obstacle, r.grains.position[i]) ? -1 : 1);
      const double overlap = r.grains.radius[i] - outside;
      if (overlap <= 0 || outside == 0) continue;
      // One that lies deep goes no faster than one that just overlaps.
      r.force[i] += (std::min(overlap, r.grains.radius[i]) / (r.unit * outside)) * way;
      r.largest_overlap = std::max(r.largest_overlap, overlap / r.grains.radius[i]);
    }
}

/// The inertia of FIRE: faster while downhill, stopped when uphill.
struct Inertia {
  double dt = 0.1, mixing = 0.1;
  int downhill_steps = 0;

  template <int D> void steer(std::vector<Vec<D>>& velocity, const std::vector<Vec<D>>& force) {
    double power = 0, v2 = 0, f2 = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      power += dot(velocity[i], force[i]);
      v2 += dot(velocity[i], velocity[i]);
      f2 += dot(force[i], force[i]);
    }
    if (power <= 0) {
      std::fill(velocity.begin(), velocity.end(), Vec<D>{});
      dt *= 0.5;
      mixing = 0.1;
      downhill_steps = 0;
      return;
    }
    const double along = f2 > 0 ? mixing * std::sqrt(v2 / f2) : 0;
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = (1 - mixing) * velocity[i] + along * force[i];
    if (++downhill_steps > 5) {
      dt = std::min(1.1 * dt, 0.5);
      mixing *= 0.99;
    }
  }
};

}  // namespace

template <int D>
RelaxReport relax(GrainsIn<D>& grains, const DomainIn<D>& domain, double tolerance, int max_iterations) {
  RelaxReport report;
  if (grains.size() == 0) return report;
  const std::vector<Vec<D>> start = grains.position;

  Relaxation<D> relaxation(grains, domain);
  Inertia inertia;
  relaxation.compute_forces();
  report.overlap_before = relaxation.largest_overlap;
  while (relaxation.largest_overlap > tolerance && report.iterations < max_iterations) {
    inertia.steer(relaxation.velocity, relaxation.force);
    relaxation.move(inertia.dt);
    relaxation.compute_forces();
    ++report.iterations;
  }
  relaxation.wrap();
  report.overlap_after = relaxation.largest_overlap;
  for (std::size_t i = 0; i < grains.size(); ++i)
    report.largest_move = std::max(report.largest_move, norm(domain.nearest_image(grains.position[i] - start[i])));
  return report;
}

double height_for(const Grains& grains, double width, double solid_fraction) {
  return grains.area() / (solid_fraction * width);
}
double height_for(const GrainsIn<3>& grains, double width, double depth, double solid_fraction) {
  return grains.volume() / (solid_fraction * width * depth);
}

namespace {

/// How dense grains can be, and are if they fill a container.
constexpr double densest(const Grains&) { return 0.9069; }       // equal disks in a triangular lattice
constexpr double densest(const GrainsIn<3>&) { return 0.7405; }  // equal spheres in that of Kepler
constexpr double loosest_jam(const Grains&) { return 0.80; }
constexpr double loosest_jam(const GrainsIn<3>&) { return 0.60; }
double filled(const Grains& grains, const Domain& domain) { return grains.area() / domain.area(); }
double filled(const GrainsIn<3>& grains, const DomainIn<3>& domain) { return grains.volume() / volume_of(domain); }

}  // namespace

template <int D> RelaxReport fill_at_random(GrainsIn<D>& grains, const DomainIn<D>& domain, std::uint64_t seed) {
  for (std::size_t i = 0; i < grains.size(); ++i) {
    RandomStream random(seed, Purpose::position, i);
    grains.position[i] = by_axis<D>([&](int axis) {
      const double margin = domain.periodic[axis] ? 0 : grains.radius[i];
      return random.uniform(domain.wall[2 * axis].position + margin, domain.wall[2 * axis + 1].position - margin);
    });
  }
  const double asked = filled(grains, domain);
  if (asked > densest(grains))
    throw refusal(
        "the grains cover {:.3g} times the {} of the container and cannot fit; use fewer, or leave container.height "
        "out with a packing.solid_fraction of {:.2f} or less",
        asked, D == 2 ? "area" : "volume", loosest_jam(grains));
  const auto report = relax<D>(grains, domain);
  if (report.overlap_after > 0.01)
    throw refusal(
        "a random filling at solid fraction {:.3f} jams with overlaps of {:.1f} % of the radii; start looser "
        "(packing.solid_fraction of {:.2f} or less, or a larger container.height) and let a loading stage compact it",
        asked, 100 * report.overlap_after, std::min(loosest_jam(grains), std::floor(100 * asked) / 100 - 0.03));
  return report;
}

#define ARENITE_OF(D)                                                           \
  template RelaxReport relax<D>(GrainsIn<D>&, const DomainIn<D>&, double, int); \
  template RelaxReport fill_at_random<D>(GrainsIn<D>&, const DomainIn<D>&, std::uint64_t);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

double fill_lattice(Grains& grains, const Domain& domain) {
  const double site = 2 * *std::max_element(grains.radius.begin(), grains.radius.end());
  const double rise = site * std::sqrt(3.0) / 2;
  const double room = domain.width() / site * (1 + 1e-12);
  const int full = static_cast<int>(room);
  const int shifted = room - full >= 0.5 ? full : full - 1;
  if (full < 1 || (shifted < 1 && grains.size() > 1))
    throw refusal("the container is {:g} m wide and holds no row of a lattice of {:g} m; widen container.width",
                  domain.width(), site);
  std::size_t i = 0;
  double y = domain.wall[bottom].position + site / 2;
  for (int row = 0; i < grains.size(); ++row, y += rise) {
    const double x0 = domain.wall[left].position + site * (row % 2 == 0 ? 0.5 : 1.0);
    for (int k = 0; k < (row % 2 == 0 ? full : shifted) && i < grains.size(); ++k, ++i) {
      grains.position[i] = {x0 + k * site, y};
    }
  }
  return y - rise + site / 2 - domain.wall[bottom].position;
}

double fill_lattice(GrainsIn<3>& spheres, const DomainIn<3>& domain) {
  const double site = 2 * *std::max_element(spheres.radius.begin(), spheres.radius.end());
  const double rise = site * std::sqrt(0.5);
  // Layers lie in the holes of those below them: every other one is shifted by half a site along x and z.
  const auto sites = [&](int axis, bool shifted) {
    const double room = domain.size()[axis] / site * (1 + 1e-12);
    return static_cast<int>(shifted && !domain.periodic[axis] ? room - 0.5 : room);
  };
  const int least = std::min(sites(0, true), sites(2, true));
  if (std::min(sites(0, false), sites(2, false)) < 1 || (least < 1 && spheres.size() > 1))
    throw refusal("the container is {:g} m wide and {:g} m deep and holds no layer of a lattice of {:g} m; enlarge it",
                  domain.size().x, domain.size().z, site);
  std::size_t i = 0;
  int layers = 0;
  for (; i < spheres.size(); ++layers) {
    const bool shifted = layers % 2 == 1;
    const auto start = [&](int axis) {
      return domain.corner()[axis] + (!shifted ? site / 2 : domain.periodic[axis] ? 0 : site);
    };
    const double y = domain.corner().y + site / 2 + layers * rise;
    for (int k = 0; k < sites(2, shifted); ++k)
      for (int j = 0; j < sites(0, shifted) && i < spheres.size(); ++j, ++i)
        spheres.position[i] = {start(0) + j * site, y, start(2) + k * site};
  }
  // Under its own image the last layer lies as in a hole where it is a shifted one.
  return domain.periodic[1] && layers % 2 == 0 ? layers * rise : (layers - 1) * rise + site;
}

}  // namespace arenite::packing
