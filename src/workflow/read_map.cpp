#include "workflow/read_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/disk/store_file.hpp"
#include "io/image/phase_map.hpp"
#include "io/image/pixel_size.hpp"
#include "io/results/results.hpp"
#include "io/volume/spheres.hpp"
#include "recipe/given.hpp"
#include "solid/grid/map_numbers.hpp"
#include "thermal/imaging/label_grains.hpp"
#include "workflow/load_voxels.hpp"

namespace arenite::workflow {
namespace {

bool is_own_field(const recipe::MapSection& map) { return io::stored_kind(map.file) == "field"; }

io::PhaseMapOptions options_of(const recipe::MapSection& map) {
  io::PhaseMapOptions options;
  options.image = {map.slice, map.dataset};
  options.label_image = {map.label_slice, map.label_dataset};
  if (!map.phases.empty()) options.phases = io::parse_phase_table(map.phases);
  if (!map.crop.empty()) options.crop = io::parse_crop(map.crop);
  options.dx = map.dx.value_or(options.dx);
  if (map.has_label_file()) options.labels = map.labels;
  return options;
}

io::StatedOf stated_of(const recipe::MapSection& map) {
  return {.dataset = map.dataset, .is_stack = false, .dx_given = map.dx.has_value()};
}

/// Where cutting at necks finds many more grains, those that touch were counted as one.
void tell_of_touching(const PhaseMap& map, const recipe::MapSection& section,
                      const std::function<void(const std::string&)>& notice) {
  constexpr double many_more = 1.3;
  PhaseMap cut = map;
  imaging::label_grains(cut, {imaging::Labelling::watershed, section.smoothing}, section.periodic);
  const std::size_t found = map.grain_class.size(), apart = cut.grain_class.size();
  if (static_cast<double>(apart) < many_more * static_cast<double>(found)) return;
  notice(
      fmt::format("{}: grains that touch count as one: {} grains, {} where they are cut at their necks by `{} "
                  "watershed` (labels = \"watershed\" in [map] of a recipe)",
                  section.file, found, apart, option("labels")));
}

/// What a map is read from, by which some of its keys have an effect.
enum Source : unsigned { from_picture = 1, from_field = 2, from_volume = 4, from_spheres = 8 };
constexpr unsigned from_pixels = from_picture | from_volume, from_files = from_pixels | from_spheres;

Source source_of(const recipe::MapSection& map) {
  if (io::is_sphere_table(map.file)) return from_spheres;
  if (is_in_space(map)) return from_volume;
  return is_own_field(map) ? from_field : from_picture;
}

struct KeyOfSources {
  std::string_view key;
  unsigned sources;
  const char* words;
  bool (*is_given)(const recipe::MapSection&);
};
constexpr KeyOfSources keys_of_sources[] = {
    {"phases", from_pixels, "a picture or a volume", [](const auto& map) { return !map.phases.empty(); }},
    {"labels", from_pixels, "a picture or a volume",
     [](const auto& map) { return map.labels != recipe::MapSection{}.labels; }},
    {"dx", from_pixels, "a picture or a volume", [](const auto& map) { return map.dx.has_value(); }},
    {"periodic", from_pixels, "a picture or a volume", [](const auto& map) { return map.periodic; }},
    {"dataset", from_pixels, "a picture or a volume", [](const auto& map) { return !map.dataset.empty(); }},
    {"label_dataset", from_pixels, "a picture or a volume", [](const auto& map) { return !map.label_dataset.empty(); }},
    {"crop", from_files, "a picture", [](const auto& map) { return !map.crop.empty(); }},
    {"slice", from_files, "a picture", [](const auto& map) { return map.slice.has_value(); }},
    {"label_slice", from_files, "a picture", [](const auto& map) { return map.label_slice.has_value(); }},
    {"voxels", from_spheres, "a table of spheres",
     [](const auto& map) { return map.voxels != recipe::MapSection{}.voxels; }},
    {"cement", from_spheres, "a table of spheres",
     [](const auto& map) { return map.cement != recipe::MapSection{}.cement; }}};

}  // namespace

std::string idle_without(std::string_view key, const recipe::MapSection& map) {
  if (key == "dimension") return map.dimension == 2 && is_in_space(map) ? "a picture" : "";
  if (key == "horizon_in_space") return is_in_space(map) ? "" : "a sample in space";
  if (key == "smoothing") return map.labels == "watershed" ? "" : option("labels") + " watershed";
  const auto at = std::ranges::find(keys_of_sources, key, &KeyOfSources::key);
  return at == std::end(keys_of_sources) || (at->sources & source_of(map)) != 0 ? "" : at->words;
}

std::vector<std::string> idle_keys(const recipe::MapSection& map) {
  std::vector<std::string> sentences;
  for (const KeyOfSources& each : keys_of_sources)
    if (each.is_given(map) && (each.sources & source_of(map)) == 0)
      sentences.push_back(recipe::left_aside(each.key, each.words));
  return sentences;
}

PhaseMap read_map(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  if (map.dimension == 3) refuse(map.file, "is a sample in space where a map of the plane is wanted");
  if (!map.box.empty()) refuse(map.file, "is a picture, and box is of a table of spheres; use crop");
  if (is_own_field(map)) return io::read_field(map.file).map;
  auto read = io::read_phase_map(map.file, options_of(map));
  if (const auto pixel = io::stated_pixel(map.file, stated_of(map))) {
    const std::string told = map.dx ? io::told_other_side("pixel", *pixel, *map.dx) : io::told_pixel(*pixel);
    if (!told.empty()) read.notes.push_back(told);
  }
  for (const auto& note : read.notes) notice(fmt::format("{}: {}", map.file, note));
  if (read.labelled) return std::move(read.map);
  if (map.labels == "none") io::label_alike(read.map);
  else imaging::label_grains(read.map, map.label_options(), map.periodic);
  if (map.labels == "components") tell_of_touching(read.map, map, notice);
  return std::move(read.map);
}

FieldResult read_sample(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  FieldResult sample = sample_of_map(read_map(map, notice));
  if (map.dx || is_own_field(map)) return sample;
  Numbers& numbers = sample.numbers["map"];
  numbers.erase("dx_m");
  numbers["lengths"] = "in nodes, since dx was not given";
  return sample;
}

void require_length(const recipe::MapSection& map, const recipe::Load& load) {
  if (!load.failure || map.dx || is_own_field(map)) return;
  const auto pixel = io::stated_pixel(map.file, stated_of(map));
  throw crack_without_length(pixel ? io::told_pixel(*pixel) : side_to_give("pixel"));
}

InputError crack_without_length(const std::string& mend) { return InputError("a crack needs a length; " + mend); }

std::string side_to_give(std::string_view of) {
  return fmt::format("give the side of a {}, for example {} \"25 um\" (dx in [map] of a recipe)", of, option("dx"));
}

FieldResult sample_of_map(PhaseMap map, const grid::CavityRules& rules) {
  check(map);
  std::size_t particle = 0;
  for (const Phase p : map.phase) particle += p == Phase::particle;
  // Without particles the unit of volume is a node.
  const double grains = static_cast<double>(map.grain_class.size());
  const double nodes_per_grain = grains > 0 && particle > 0 ? static_cast<double>(particle) / grains : 1;
  FieldResult sample;
  sample.name = "map";
  sample.numbers = grid::map_numbers(map, rules, map.dx * grid::radius_over(nodes_per_grain));
  sample.map = std::move(map);
  return sample;
}

}  // namespace arenite::workflow
