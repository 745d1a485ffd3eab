// Writes the benchmark's packings for the peers: NAME.data (LAMMPS, SI), and of disks NAME.csv (x, y, radius).
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "grains/texture/texture.hpp"
#include "model/shapes.hpp"
#include "samples.hpp"

namespace {

using namespace arenite;

/// What stands before the list of atoms.
std::string head(const std::string& name, const Packing& p, std::size_t atoms, const std::string& more) {
  const double margin = p.domain.periodic[0] ? 0.0 : 1e-3;  // LAMMPS shrinks its box to the grains; walls are its fixes
  const auto& w = p.domain.wall;
  return fmt::format("{}\n\n{} atoms\n1 atom types\n{}\n", name, atoms, more) +
         fmt::format("{:.17g} {:.17g} xlo xhi\n", w[left].position - margin, w[right].position + margin) +
         fmt::format("{:.17g} {:.17g} ylo yhi\n-0.008 0.008 zlo zhi\n\nAtoms\n\n", w[bottom].position - margin,
                     w[top].position + margin);
}

/// LAMMPS gives a disk the mass of a sphere; with this density it has the given one.
double density_for(double mass, double radius) { return 0.75 * mass / (std::numbers::pi * radius * radius * radius); }

void write_disks(const std::filesystem::path& folder, const std::string& name, const Packing& p) {
  const auto& w = p.domain.wall;
  std::ofstream data(folder / (name + ".data")), table(folder / (name + ".csv"));
  data << head(name, p, p.grains.size(), "");
  table << fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", w[left].position, w[right].position, w[bottom].position,
                       w[top].position);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const double r = p.grains.radius[k];
    data << fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} 0\n", k + 1, 2 * r, density_for(mass_of(p, k), r),
                        p.grains.position[k].x, p.grains.position[k].y);
    table << fmt::format("{:.17g},{:.17g},{:.17g}\n", p.grains.position[k].x, p.grains.position[k].y, r);
  }
}

/// What stands before the sections of spheres.
std::string head(const std::string& name, const PackingIn<3>& p, const std::string& more) {
  std::string text = fmt::format("{}\n\n{} atoms\n1 atom types\n{}", name, p.grains.size(), more);
  const auto& w = p.domain.wall;
  for (int axis = 0; axis < 3; ++axis)
    text += fmt::format("{:.17g} {:.17g} {}lo {}hi\n", w[2 * axis].position, w[2 * axis + 1].position, "xyz"[axis],
                        "xyz"[axis]);
  return text;
}

void write_spheres(const std::filesystem::path& folder, const std::string& name, const PackingIn<3>& p) {
  std::ofstream data(folder / (name + ".data"));
  data << head(name, p, "") << "\nAtoms\n\n";
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    data << fmt::format("{} 1 {:.17g} {} {:.17g} {:.17g} {:.17g}\n", k + 1, 2 * p.grains.radius[k],
                        p.materials[0].density, p.grains.position[k].x, p.grains.position[k].y, p.grains.position[k].z);
}

/// The same bonded as the benchmark bonds them; each bond is of a type of its own, whose spring has the stiffness of
/// the bond along its axis and is without force.
void write_bonded(const std::filesystem::path& folder, const std::string& name, const PackingIn<3>& p) {
  dem::ContactParameters contact = bench::contact_parameters();
  contact.bonds = bench::bond();
  dem::EngineIn<3> engine(p, contact, {});
  make_bonds(engine);
  const PackingIn<3> held = packing_of(engine);
  std::ofstream data(folder / (name + ".data"));
  data << head(name, p, fmt::format("{0} bonds\n{0} bond types\n", held.bonds.size()));
  std::string springs = "\nBond Coeffs\n\n", pairs = "\nBonds\n\n";
  for (std::size_t b = 0; b < held.bonds.size(); ++b) {
    const auto& bond = held.bonds[b];
    const double radius =
        std::min(p.grains.radius[static_cast<std::size_t>(bond.i)], p.grains.radius[static_cast<std::size_t>(bond.j)]);
    const double stiffness = bench::bond().round_beam(bond.length, radius).normal;
    fmt::format_to(std::back_inserter(springs), "{} {:.17g} {:.17g}\n", b + 1, stiffness / 2, bond.length);
    fmt::format_to(std::back_inserter(pairs), "{0} {0} {1} {2}\n", b + 1, bond.i + 1, bond.j + 1);
  }
  data << springs << "\nAtoms\n\n";
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    data << fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} {} 0\n", k + 1, p.grains.position[k].x,
                        p.grains.position[k].y, p.grains.position[k].z, 2 * p.grains.radius[k], p.materials[0].density);
  data << pairs;
}

/// Disks of clumps, each with the number of its clump as that of its molecule.
void write_clumps(const std::filesystem::path& folder, const std::string& name, const Packing& p) {
  const Shapes& shapes = p.grains.shapes;
  std::ofstream data(folder / (name + ".data"));
  data << head(name, p, shapes.place.size(), "");
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const Vec2 by = direction(p.grains.angle[g]);
    const auto first = static_cast<std::size_t>(shapes.first[g]), last = static_cast<std::size_t>(shapes.first[g + 1]);
    for (std::size_t d = first; d < last; ++d) {
      const Vec2 at = p.grains.position[g] + turned(shapes.place[d], by);
      data << fmt::format("{} 1 {:.17g} {:.17g} 0 {:.17g} {:.17g} {}\n", d + 1, at.x, at.y, 2 * shapes.radius[d],
                          density_for(mass_of(p, g) / static_cast<double>(last - first), shapes.radius[d]), g + 1);
    }
  }
}

/// Bodies of style rounded/polygon: moments of inertia, corners, twice the radius of the corners.
void write_polygons(const std::filesystem::path& folder, const std::string& name, const Packing& p) {
  const Shapes& shapes = p.grains.shapes;
  std::ofstream data(folder / (name + ".data"));
  data << head(name, p, p.grains.size(), fmt::format("{} bodies\n", p.grains.size()));
  std::string bodies = "\nBodies\n\n";
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    data << fmt::format("{} 1 1 {:.17g} {:.17g} {:.17g} 0\n", g + 1, mass_of(p, g), p.grains.position[g].x,
                        p.grains.position[g].y);
    const Vec2 by = direction(p.grains.angle[g]);
    const auto first = static_cast<std::size_t>(shapes.first[g]),
               corners = static_cast<std::size_t>(shapes.first[g + 1]) - first;
    const double inertia = mass_of(p, g) * shapes.gyration[g] * shapes.gyration[g];
    auto to = std::back_inserter(bodies);
    fmt::format_to(to, "{} 1 {}\n{}\n{:.17g} {:.17g} {:.17g} 0 0 0\n", g + 1, 7 + 3 * corners, corners, inertia / 2,
                   inertia / 2, inertia);
    for (std::size_t d = first; d < first + corners; ++d) {
      const Vec2 at = turned(shapes.place[d], by);
      fmt::format_to(to, "{:.17g} {:.17g} 0\n", at.x, at.y);
    }
    fmt::format_to(to, "{:.17g}\n", 2 * shapes.radius[first]);
  }
  data << bodies;
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fputs("usage: export_packing FOLDER [NAME..]      (only these packings)\n", stderr);
    return 2;
  }
  const std::vector<std::string> wanted(words + 2, words + count);
  const auto put = [&](const std::string& name, const auto& write, const auto& packing) {
    if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) write(words[1], name, packing());
  };
  put("walls_4000", write_disks, bench::walls_4000);
  put("periodic_100000", write_disks, bench::periodic_100000);
  put("spheres_4000", write_spheres, bench::spheres_4000);
  put("spheres_4000_bonded", write_bonded, bench::spheres_4000);
  put("spheres_100000", write_spheres, bench::spheres_100000);
  put("clumps_4000", write_clumps, bench::clumps_4000);
  put("polygons_4000", write_polygons, bench::polygons_4000);
  return 0;
}
