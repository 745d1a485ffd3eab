#include "phase_map_arguments.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/units.hpp"

namespace arenite::app {
namespace {

/// Rethrows an error without place as one of an option.
template <class Read>
auto option_value(const char* option, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(std::string(option) + ": " + error.problems().front().message);
  }
}

/// Words of a list may stand with blanks between them.
std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

}  // namespace

void add_phase_map(CLI::App& command, PhaseMapArguments& a) {
  command.add_option("map", a.file, "Phase map: PNG, TIFF or HDF5 with one value a phase, or a result of Arenite")->required()->type_name("PHASEMAP");
  command.add_option("--phases", a.phases, "Which value is which phase, e.g. \"0=void,128=matrix,255=particle\"; two values are guessed")->type_name("TABLE");
  command.add_option("--slice", a.slice, "Slice of a stack, from 0")->check(CLI::NonNegativeNumber)->type_name("NUMBER");
  command.add_option("--dataset", a.dataset, "Dataset of an HDF5 file, if several can be meant")->type_name("NAME");
  command.add_option("--crop", a.crop, "Part of the picture: its upper left pixel and its size")->type_name("X,Y,WIDTH,HEIGHT");
  command.add_option("--pixel", a.dx, "Side of a pixel, e.g. \"2 um\"; default 1 m")->type_name("LENGTH");
  command.add_option("--labels", a.labels, "Picture whose values number the grains, 0 where there is none")->type_name("FILE");
  command.add_option("--label-dataset", a.label_dataset, "Dataset of the labels, in --labels or in the map's own file")->type_name("NAME");
  command.add_option("--grains", a.grains, "Grains of a map without labels: components (connected particles), or watershed (touching ones come apart)")
      ->check(CLI::IsMember({"components", "watershed"}))->type_name("WAY");
  command.add_option("--smoothing", a.smoothing, "Of the watershed, in pixels: more joins what a rough outline would cut; default 1")->type_name("NUMBER");
}

study::LabelledMap read_phase_map(const PhaseMapArguments& a) {
  study::ForeignMapOptions o;
  if (!a.phases.empty()) o.reading.phases = option_value("--phases", [&] { return io::parse_phase_table(without_blanks(a.phases)); });
  if (!a.crop.empty()) o.reading.crop = option_value("--crop", [&] { return io::parse_crop(without_blanks(a.crop)); });
  if (!a.dx.empty()) o.reading.dx = option_value("--pixel", [&] { return parse_si(a.dx, dimension::length, "um"); });
  if (!(o.reading.dx > 0)) throw InputError("--pixel: the side of a pixel must be positive");
  if (a.slice >= 0) o.reading.image.slice = a.slice;
  o.reading.image.dataset = a.dataset;
  if (!a.labels.empty()) o.reading.labels = a.labels;
  o.reading.label_image.dataset = a.label_dataset;
  o.labelling.way = a.grains == "watershed" ? imaging::Labelling::watershed : imaging::Labelling::components;
  o.labelling.smoothing = a.smoothing;
  return study::read_foreign_map(a.file, o);
}

}  // namespace arenite::app
