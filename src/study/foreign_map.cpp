#include "study/foreign_map.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "io/field_file.hpp"
#include "io/sealed_file.hpp"

namespace arenite::study {
namespace {

/// One grain of most of the particles is what touching grains look like to connected components.
constexpr double suspicious_share = 0.25;

std::string how_labelled(const imaging::LabelReport& found, const imaging::LabelOptions& options) {
  if (options.way == imaging::Labelling::watershed)
    return fmt::format("{} grains found by a watershed of the distance transform, smoothed by {:g} nodes.", found.grains,
                       options.smoothing);
  return fmt::format("{} grains found as connected particles.", found.grains);
}

/// The map of a result of ours: its phases, labels and spacing are known.
LabelledMap own_map(const std::filesystem::path& path, const io::PhaseMapOptions& reading) {
  if (!reading.phases.empty() || reading.crop || reading.labels || reading.dx != 1 || reading.image.slice ||
      !reading.image.dataset.empty() || !reading.label_image.dataset.empty())
    throw InputError(path.string(), 0,
                     "is a result of Arenite, whose phases, grains and pixels are known; leave out the options that say them");
  return {io::read_field(path).map, {"The map is that of a result of Arenite."}};
}

}  // namespace

LabelledMap read_foreign_map(const std::filesystem::path& path, const ForeignMapOptions& options) {
  const std::string kind = io::sealed_kind(path);
  if (kind == "field") return own_map(path, options.reading);
  if (!kind.empty())
    throw InputError(path.string(), 0, "is a result of Arenite without a phase map; give one of a raster or of a load");
  io::ForeignMap read = io::read_phase_map(path, options.reading);
  LabelledMap result{std::move(read.map), std::move(read.notes)};
  if (read.labelled) {
    result.notes.push_back(fmt::format("{} grains by the labels given.", result.map.grain_class.size()));
    return result;
  }
  const imaging::LabelReport found = imaging::label_grains(result.map, options.labelling);
  if (found.grains == 0) return result;
  result.notes.push_back(how_labelled(found, options.labelling));
  if (found.grains > 1 && found.largest_share > suspicious_share && options.labelling.way == imaging::Labelling::components)
    result.notes.push_back(fmt::format("The largest of them holds {:.3g} % of the particle nodes: if grains touch, find them with --grains watershed.",
                                       100 * found.largest_share));
  return result;
}

}  // namespace arenite::study
