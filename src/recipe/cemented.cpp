#include "recipe/cemented.hpp"

#include <fmt/core.h>

#include <numbers>
#include <string>
#include <vector>

#include "model/grain_classes.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

std::vector<Word> words(cement::CementParameters::Kind) {
  return {{"none", "nowhere"},
          {"bridges", "trapezia between neighbouring grains"},
          {"full", "in all space between the grains"},
          {"coating", "a layer of uniform thickness around every grain"},
          {"menisci", "between two arcs that touch both neighbours, like a liquid"}};
}

std::vector<Word> words(grid::Cavity) {
  return {{"pore", "space between grains, matrix or empty"}, {"void", "empty space"}};
}

void declare(Visitor& v, cement::CementParameters& law, int dimension) {
  using Kind = cement::CementParameters::Kind;
  v.choice({"kind", "Where the matrix is placed."}, law.kind, words(law.kind));
  static const std::string gap = fmt::format(
      "Widest surface gap that is bridged, and in the plane at which two grains count as neighbours; unless given, {} "
      "of the mean large radius.",
      SampleLengths::gap_over_radius);
  v.number({"gap", gap}, law.gap, "mm", range::not_negative);
  const bool is_free = law.kind == Kind::bridges || law.kind == Kind::coating || law.kind == Kind::menisci;
  v.when(is_free, "kind = \"bridges\", \"coating\" or \"menisci\"", [&](Visitor& inner) {
    inner.number(
        {"saturation",
         "S_m, the fraction of the space between grains filled by matrix: width, thickness or volume is then "
         "found so that it holds in the square that becomes the grid (`[grid] crop`), in space on the voxels."},
        law.saturation, "", range::above(0, 1));
  });
  const bool given = !law.saturation;
  v.when(law.kind == Kind::bridges, "kind = \"bridges\"", [&](Visitor& inner) {
    inner.flag({"full_width", "width is the full base of a neck over the radius, not half of it."}, law.full_width);
  });
  const bool by_width = law.kind == Kind::bridges || (dimension == 3 && law.kind == Kind::menisci);
  v.when(by_width && given, "kind = \"bridges\", or in space \"menisci\", without saturation", [&](Visitor& inner) {
    inner.number({"width",
                  "eta: half base of a neck over the radius of its grain; menisci in space end on such a circle of the "
                  "smaller grain."},
                 law.width, "", range::above(0, 2));
  });
  v.when(law.kind == Kind::coating && given, "kind = \"coating\" without saturation", [&](Visitor& inner) {
    inner.number({"thickness", "Thickness of the layer.", true}, law.thickness, "mm", range::positive);
  });
  const bool round = law.kind == Kind::menisci && dimension == 3;
  if (dimension == 2)  // a table of spheres is never in the plane, and does not name this key
    v.when(law.kind == Kind::menisci && given, "kind = \"menisci\" in the plane, without saturation",
           [&](Visitor& inner) {
             inner.number({"volume", "Volume of one meniscus per unit length.", true}, law.volume, "mm^2",
                          range::positive);
           });
  v.when(round, "kind = \"menisci\" in space", [&](Visitor& inner) {
    inner.number({"contact_angle", "Angle at which the matrix meets a sphere, measured in the matrix."},
                 law.contact_angle, "deg", range::between(0, 80 * std::numbers::pi / 180));
  });
}

void declare(Visitor& v, GridSection& grid, int dimension) {
  static const std::string
      nodes =
          fmt::format("Nodes along a side of the square; in space voxels along a side of the cube, {} unless given.",
                      GridSection{}.voxels),
      crop = fmt::format(
          "Side of the centred square to crop; unless given, {} mean large radii of a sampled packing, otherwise the "
          "largest square, in space the largest cube, inside the sample.",
          SampleLengths::window_over_radius);
  v.integer({"nodes", nodes}, dimension == 3 ? grid.voxels : grid.nodes, {7, 32'768});
  v.number({"crop", crop}, grid.crop, "mm", range::positive);
  v.flag({"eight_connected", "Pores and voids are also connected across corners."}, grid.cavities.eight_connected);
  v.integer({"fewest_nodes", "Pores and voids of fewer nodes are artefacts of the grid and left out."},
            grid.cavities.fewest_nodes, {1, 1'000'000});
  v.flag({"leave_out_border", "Pores and voids that touch the edge are cut, and left out."},
         grid.cavities.leave_out_border);
}

}  // namespace arenite::recipe
