#include <string>
#include <vector>

#include <fmt/core.h>

#include "io/export/export.hpp"
#include "io/export/vtk_file.hpp"

namespace arenite::io {
namespace {

std::string fields_file(int number) { return fmt::format("fields_{:04}.vti", number); }

/// Points of ImageData with `velocity`, `stress` (xx, yy, zz, xy, yz, xz) and the scalars. Nothing for a state without
/// a box.
std::vector<NamedBytes> fields_snapshot(const ExportSnapshot& from) {
  const GridFields& g = from.grid;
  if (g.columns == 0) return {};
  VtkImage image{g.columns, g.rows, g.dx, {}, g.dy, g.left, g.bottom};
  for (const GrainField& field : g.scalars) image.point_arrays.push_back({field.name, field.values});
  image.point_arrays.push_back({"velocity", in_space(g.velocity), 3});
  image.point_arrays.push_back({"stress", symmetric(g.stress_xx, g.stress_yy, g.stress_xy), 6});
  return {{fields_file(from.number), vti_bytes(image)}};
}

std::vector<NamedBytes> fields_index(const std::vector<double>& times) {
  return {{"fields.pvd", pvd_bytes(times, fields_file)}};
}

}  // namespace

const ExportFormat exports::fields{
    .name = "fields",
    .sentence =
        "ParaView: coarse-grained fields of all states (solid fraction, density, velocity, stress), open fields.pvd",
    .states =
        {{"fields",
          "solid fraction, density, velocity, stress with its kinetic part, on points half a mean diameter apart"},
         {"grains, contacts, walls", "left out: `vtk` has them"},
         {"a state without a box", "refused"}},
    .wants_grid = true,
    .of_snapshot = fields_snapshot,
    .index = fields_index};

}  // namespace arenite::io
