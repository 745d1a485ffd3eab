// Writes the benchmark's packings for the peers: NAME.data (LAMMPS, atom style sphere, SI) and NAME.csv (x, y, radius).
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "samples.hpp"

namespace {

using namespace arenite;

void write(const std::filesystem::path& folder, const std::string& name, const Packing& p) {
  const double margin = p.domain.periodic_x ? 0.0 : 1e-3;  // LAMMPS shrinks its box to the grains; walls are its fixes
  const auto& w = p.domain.wall;
  std::ofstream data(folder / (name + ".data")), table(folder / (name + ".csv"));
  data << fmt::format("{}\n\n{} atoms\n1 atom types\n\n", name, p.grains.size())
       << fmt::format("{:.17g} {:.17g} xlo xhi\n", w[left].position - margin, w[right].position + margin)
       << fmt::format("{:.17g} {:.17g} ylo yhi\n-0.008 0.008 zlo zhi\n\nAtoms # sphere\n\n", w[bottom].position - margin, w[top].position + margin);
  table << fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", w[left].position, w[right].position, w[bottom].position, w[top].position);
  const double density = p.materials[0].density * p.domain.thickness;
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const double r = p.grains.radius[k];
    // LAMMPS gives a grain the mass of a sphere; this density makes it that of our disk.
    data << fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} 0\n", k + 1, 2 * r, 0.75 * density / r, p.grains.x[k], p.grains.y[k]);
    table << fmt::format("{:.17g},{:.17g},{:.17g}\n", p.grains.x[k], p.grains.y[k], r);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: export_packing FOLDER\n", stderr);
    return 2;
  }
  write(words[1], "walls_4000", bench::walls_4000());
  write(words[1], "periodic_100000", bench::periodic_100000());
  return 0;
}
