#include "grains/lammps/data.hpp"

#include <fmt/core.h>

#include <iterator>
#include <numbers>
#include <vector>

#include "grains/dem/measure.hpp"

namespace arenite::lammps {
namespace {

/// The layer that LAMMPS gives a plane.
template <int D> std::string depth_of(const dem::SampleIn<D>& sample);
template <> std::string depth_of(const dem::SampleIn<2>& s) {
  return fmt::format("{:.17g} {:.17g} zlo zhi\n", -s.largest_radius, s.largest_radius);
}
template <> std::string depth_of(const dem::SampleIn<3>& /*sample*/) { return ""; }

template <int D> std::vector<double> masses_of(const dem::SampleIn<D>& s) {
  std::vector<double> mass(s.count);
  for (std::size_t k = 0; k < s.count; ++k) mass[s.record[k].grain] = s.record[k].mass;
  return mass;
}

}  // namespace

template <int D> std::string data_of(const dem::SampleIn<D>& s, const std::string& title) {
  const PackingIn<D> now = dem::packing_of<D>(s);
  const GrainsIn<D>& g = now.grains;
  std::string text = fmt::format("{}\n\n{} atoms\n{} atom types\n\n", title, g.size(), now.materials.size());
  const auto to = std::back_inserter(text);
  for (int axis = 0; axis < D; ++axis) {
    const char letter = "xyz"[axis];
    fmt::format_to(to, "{:.17g} {:.17g} {}lo {}hi\n", now.domain.wall[2 * axis].position,
                   now.domain.wall[2 * axis + 1].position, letter, letter);
  }
  text += depth_of(s) + "\nAtoms # sphere\n\n";
  const std::vector<double> mass = masses_of(s);
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double r = g.radius[k];
    const Vec3 place = in_space(now.domain.wrapped(g.position[k]));
    fmt::format_to(to, "{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1, g.material[k] + 1, 2 * r,
                   0.75 * mass[k] / (std::numbers::pi * r * r * r), place.x, place.y, place.z);
  }
  text += "\nVelocities\n\n";
  const auto cell = dem::cell_motion(now.domain);  // LAMMPS's velocities are those within a cell that moves
  for (std::size_t k = 0; k < g.size(); ++k) {
    const Vec3 v = in_space(g.velocity[k] - cell.at(g.position[k])), w = turning_in_space(g.omega[k]);
    fmt::format_to(to, "{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1, v.x, v.y, v.z, w.x, w.y, w.z);
  }
  return text;
}

template std::string data_of(const dem::SampleIn<2>&, const std::string&);
template std::string data_of(const dem::SampleIn<3>&, const std::string&);

}  // namespace arenite::lammps
