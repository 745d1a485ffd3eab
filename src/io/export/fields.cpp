#include <string>
#include <vector>

#include <fmt/core.h>

#include "io/export/export.hpp"
#include "io/export/vtk_file.hpp"

namespace arenite::io {
namespace {

std::string fields_file(int number) { return fmt::format("fields_{:04}.vti", number); }

VtkImage image_on(const GridFieldsIn<2>& g) {
  return {g.count.x, g.count.y, g.step.x, {}, g.step.y, g.corner.x, g.corner.y};
}
VtkImage image_on(const GridFieldsIn<3>& g) {
  return {g.count.x, g.count.y, g.step.x, {}, g.step.y, g.corner.x, g.corner.y, g.count.z, {}, g.step.z, g.corner.z};
}

/// Points of ImageData with `velocity`, `stress` (xx, yy, zz, xy, yz, xz) and the scalars. Nothing for a state without
/// a box.
template <int D> std::vector<NamedBytes> fields_of_state(const ExportStateIn<D>& from) {
  const GridFieldsIn<D>& g = from.grid;
  if (g.count.x == 0) return {};
  VtkImage image = image_on(g);
  for (const GrainField& field : g.scalars) image.point_arrays.push_back({field.name, field.values});
  image.point_arrays.push_back({"velocity", in_space(g.velocity), 3});
  image.point_arrays.push_back({"stress", g.stress, 6});
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
          "solid fraction, density, velocity, stress with its kinetic part, on points half a mean diameter apart; of "
          "spheres further apart where they would be more than a million"},
         {"grains, contacts, walls", "left out: `vtk` has them"},
         {"a state without a box", "refused"}},
    .wants_grid = true,
    .of_snapshot = fields_of_state<2>,
    .index = fields_index,
    .of_spheres = fields_of_state<3>};

}  // namespace arenite::io
