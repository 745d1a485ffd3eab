#include "recipe/map_section.hpp"

#include <fmt/core.h>

#include <limits>
#include <string>

#include "io/image/phase_map.hpp"
#include "recipe/cemented.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

/// What is wrong with a text that has a form of its own; empty where nothing is, and of no text.
template <class Parse> std::string refusal(const std::string& text, Parse parse) {
  try {
    if (!text.empty()) parse(text);
    return {};
  } catch (const InputError& error) { return error.problems().front().message; }
}

std::string box_problem(const std::vector<double>& box) {
  if (box.empty()) return {};
  if (box.size() != 6) return "must be six lengths, the lowest corner x, y, z and the highest one";
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(box[axis + 3] > box[axis])) return "must name the lowest corner first, and the highest behind it";
  return {};
}

}  // namespace

geometry::LabelOptions MapSection::label_options() const {
  return {labels == "watershed" ? geometry::Labelling::watershed : geometry::Labelling::components, smoothing};
}

void declare(ParameterVisitor& v, MapSection& map) {
  v.file({"file",
          "Phase map: a picture of grey values, or a field file of Arenite (.h5), which needs no more keys; in space a "
          "volume, a folder of slices, or a table of spheres.",
          true},
         map.file);
  v.text({"phases",
          "Phase of each grey value, for example \"0=void,85=particle,170=matrix\"; not needed for a picture of two "
          "values."},
         map.phases);
  const std::string phases = refusal(map.phases, io::parse_phase_table), crop = refusal(map.crop, io::parse_crop);
  v.require(phases.empty(), {"phases"}, phases);
  v.text(
      {"labels",
       "Grains: components (connected particles), watershed (split at necks), none (all one grain), or the file of a "
       "label image."},
      map.labels);
  v.number({"smoothing", "Watershed: depth of a neck up to which it is not cut, in pixels or voxels."}, map.smoothing,
           "", range::not_negative);
  v.text({"crop", "Part of the picture to use: x, y, width and height in pixels from its upper left corner."},
         map.crop);
  v.require(crop.empty(), {"crop"}, crop);
  v.integer({"dimension", "2: a picture, or one slice of a stack; 3: all slices, a sample in space."}, map.dimension,
            {2, 3});
  constexpr IntegerRange slices{0, 1'000'000'000'000};
  v.integer({"slice", "Slice of a stack, counted from 0."}, map.slice, slices);
  v.text({"dataset", "Dataset to read from an HDF5 file that holds several."}, map.dataset);
  v.integer({"label_slice", "Slice of the labels, counted from 0."}, map.label_slice, slices);
  v.text({"label_dataset", "Dataset of the labels."}, map.label_dataset);
  v.number({"dx", "Side of a pixel; if not given, lengths are in pixels."}, map.dx, "um", range::positive);
  v.flag({"periodic", "The map repeats itself along all axes: grains go on across its sides."}, map.periodic);
  v.integer({"voxels", "Of a table of spheres: voxels along the longest side of its box."}, map.voxels, {8, 2048});
  v.numbers({"box",
             "Of a table of spheres: the part that is cut out, its lowest corner x, y, z and its highest; unless "
             "given, the smallest that holds all."},
            map.box, "mm", range::any);
  const std::string box = box_problem(map.box);
  v.require(box.empty(), {"box"}, box);
  v.section({"cement", "Of a table of spheres: the matrix between them."},
            [&](ParameterVisitor& section) { declare(section, map.cement, 3); });
}

}  // namespace arenite::recipe
