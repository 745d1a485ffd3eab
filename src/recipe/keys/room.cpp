#include "recipe/keys/room.hpp"

#include <fmt/core.h>

#include <optional>
#include <string>

#include "recipe/keys.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

/// A container is counted from its lowest corner; the lower edge of a part may be there.
void declare_fill_area(Visitor& v, std::optional<FillArea>& area, bool in_space) {
  constexpr ByAnySide<const char*> from{
      "Edge, from the container's left side.", "Edge, from the container's left side.",
      "Edge, from the container's bottom.",    "Edge, from the container's bottom.",
      "Edge, from the container's back.",      "Edge, from the container's back."};
  v.optional_section<FillArea>(
      {"area", "Part of the container to fill, for containers with boundaries; needs container.height."}, area,
      [&](Visitor& inner, FillArea& part) {
        const auto declare_edge = [&](Visitor& visitor, std::size_t side) {
          visitor.number({any_side_names[side], from[side]}, part.edge[side], "mm",
                         side % 2 == 0 ? range::not_negative : range::positive);
        };
        for (std::size_t side = left; side <= top; ++side) declare_edge(inner, side);
        inner.when(in_space, space, [&](Visitor& deep) {
          for (const std::size_t side : {back, front}) declare_edge(deep, side);
        });
      });
}

}  // namespace

void declare_container(Visitor& v, Recipe& recipe) {
  ContainerParameters& container = recipe.container;
  const PackingParameters::Method method = recipe.packing.method;
  const bool in_space = recipe.dimension == 3;
  const bool has_size = method != PackingParameters::Method::poisson;
  v.when(has_size, "packing.method other than \"poisson\", which makes its own box", [&](Visitor& inner) {
    inner.number({"width", "Inner width of the container, or of the periodic cell.", true}, container.width, "mm",
                 range::positive);
    inner.number_above_0({"height", "Inner height at the start; if not given, it follows from packing.solid_fraction."},
                         container.height, "mm");
  });
  v.when(!in_space, plane, [&](Visitor& inner) {
    inner.number({"thickness", "Length of the cylinders, out of the plane.", true}, container.thickness, "mm",
                 range::positive);
  });
  v.flag({"periodic_x", "Periodic in x: no walls on the left and right."}, container.periodic[0]);
  v.flag({"periodic_y", "Periodic in y: no walls at the bottom and top."}, container.periodic[1]);
  v.when(in_space && has_size, "dimension = 3 and a packing.method other than \"poisson\"", [&](Visitor& inner) {
    inner.number({"depth", "Inner depth, from back to front.", true}, container.depth, "mm", range::positive);
  });
  v.when(in_space, space, [&](Visitor& inner) {
    inner.flag({"periodic_z", "Periodic in z: no walls at the back and front."}, container.periodic[2]);
  });
}

void declare_packing(Visitor& v, Recipe& recipe) {
  PackingParameters& packing = recipe.packing;
  using Method = PackingParameters::Method;
  v.choice({"method", "Method that gives the initial positions of the grains."}, packing.method,
           {{"random", "at random, then relaxed until overlaps vanish"},
            {"lattice", "stacked row by row as a triangular lattice, spheres in squares as a face-centred cubic one"},
            {"file", "read from a CSV of centres, radii and materials"},
            {"poisson", "two size classes by fast Poisson disk sampling, also of spheres, defined in [bidisperse]"}});
  v.when(packing.method == Method::random || packing.method == Method::lattice, "method = \"random\" or \"lattice\"",
         [&](Visitor& inner) {
           inner.integer({"grains", "Total number of grains, if populations give ratios."}, packing.grains,
                         {0, 100'000'000});
           declare_fill_area(inner, packing.area, recipe.dimension == 3);
         });
  v.when(packing.method == Method::random, "method = \"random\"", [&](Visitor& inner) {
    static const std::string fraction = fmt::format(
        "Target solid fraction (area of grains over area of the box, in space volume over volume) of the random "
        "filling; loading compacts it. In space {} unless given.",
        PackingParameters::usual_in_space);
    inner.number({"solid_fraction", fraction}, packing.solid_fraction, "", range::above(0, 0.9));
  });
  v.when(packing.method == Method::file, "method = \"file\"", [&](Visitor& inner) {
    inner.file({"file", "CSV of the grains: id, x, y, radius, material.", true}, packing.file);
  });
}

void require_fill_area(Visitor& v, const Recipe& recipe) {
  const ContainerParameters& container = recipe.container;
  const auto& area = recipe.packing.area;
  if (!area) return;
  v.require(container.height > 0, {"container", "packing"},
            "a part of it can be filled only if its height is given; write height = \"... mm\"");
  const double size[] = {container.width, container.height, container.depth};
  bool within = true, fits = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double>&low = area->edge[2 * axis], &high = area->edge[2 * axis + 1];
    within = within && (!container.periodic[axis] || (!low && !high));
    fits = fits && ((!low && !high) ||
                    (low.value_or(0) < high.value_or(size[axis]) && high.value_or(size[axis]) <= size[axis]));
  }
  v.require(within, {"packing"}, "packing.area cannot end before a periodic side; leave out its edges there");
  v.require(fits, {"packing"}, "packing.area must lie in the container, left before right and bottom below top");
}

}  // namespace arenite::recipe
