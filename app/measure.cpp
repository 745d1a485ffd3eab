#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "core/text.hpp"
#include "grains/texture/texture.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "io/sample/formats.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "recipe/recipe.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"
#include "statistics/correlation.hpp"
#include "thermal/imaging/proposed_contacts.hpp"

namespace arenite::app {
namespace {

/// How contacts are found that no file gives.
struct ContactGap {
  std::optional<double> touching;  ///< m
};
void declare(ParameterVisitor& v, ContactGap& gap) {
  v.number({"touching",
            "Without a file of contacts: widest gap between the surfaces of grains that are taken to touch; forces are "
            "then not known."},
           gap.touching, "mm", range::positive);
}

struct MeasureArguments {
  KeyOptions measure{recipe::every_key<Measuring>()}, load{recipe::every_key<recipe::Load>()};
  KeyOptions sample{recipe::every_key<io::SampleOptions>()}, gap{recipe::every_key<ContactGap>()};
  std::string grains, contacts, periodic, doubled = "error";
  bool json = false, curves = false;
};

/// A length without unit is in that of the files.
std::string bare_length(const MeasureArguments& a) {
  const std::string unit = a.sample.text("length_unit");
  return unit.empty() ? "m" : unit;
}

io::SampleOptions sample_options(const MeasureArguments& a) {
  io::SampleOptions options;
  auto given = a.sample.given(bare_length(a));
  if (!a.periodic.empty())
    given.push_back({"--periodic", "periodic", recipe::value_of(a.sample.at("periodic"), a.periodic)});
  read_options(options, given);
  options.merge_doubled = a.doubled == "merge";
  return options;
}

/// Where no contacts are given: those between surfaces no further apart than the gap that was asked for, without
/// forces.
void propose_contacts(const MeasureArguments& a, io::Sample& sample, texture::Options& options) {
  ContactGap gap;
  read_options(gap, a.gap.given(bare_length(a)));
  imaging::ContactTolerance tolerance;
  tolerance.floor = 1;
  tolerance.pixel = gap.touching.value();
  const double mean_radius = statistics::mean_of_known(sample.packing.grains.radius);
  if (tolerance.pixel > mean_radius)
    throw InputError(fmt::format(
        "--touching: {} is wider than the mean radius of the grains, {:.4g} m; grains so far apart do not touch",
        a.gap.text("touching"), mean_radius));
  sample.packing.contacts = imaging::propose_contacts(sample.packing.grains, sample.packing.domain, {}, tolerance);
  options.rattler_contacts = 0;
  sample.notes.push_back("Grains are taken to touch where their surfaces are within " + a.gap.text("touching") +
                         " of each other; forces are not known, so statistics of forces are left out.");
}

void measure(const MeasureArguments& a) {
  io::Sample sample = io::read_sample(a.grains, a.contacts, sample_options(a));
  texture::Options options;
  read_options(static_cast<Measuring&>(options), a.measure.given());
  if (a.contacts.empty()) propose_contacts(a, sample, options);
  options.doubled_rows = sample.doubled_rows;
  texture::Texture t = texture::measure(sample.packing, options);
  if (a.contacts.empty()) texture::forget_forces(t);
  t.notes.insert(t.notes.begin(), sample.notes.begin(), sample.notes.end());
  if (sample.doubled_rows > 0)
    t.notes.insert(t.notes.begin(), std::to_string(sample.doubled_rows) +
                                        " rows repeat a contact that is already listed, and were merged with it.");
  const std::string text = a.json ? to_json(texture::numbers(t, a.curves), 2) + "\n" : texture::to_text(t);
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void add_reading(Options& command, MeasureArguments& a) {
  const auto add = [&](const char* name, const char* key) -> Option& { return a.sample.add(command, name, key); };
  add("--box", "box").type("LX,LY[,tilt]");
  add("--origin", "origin").type("X,Y");
  command.add("--periodic{xy}", a.periodic,
              recipe::help_of(a.sample.at("periodic")) + "; --periodic=x or --periodic=y for one direction");
  add("--thickness", "thickness").type("LENGTH");
  add("--materials", "materials").type("FILE");
  add("--length-unit", "length_unit").type("UNIT");
  add("--pixel", "pixel").type("LENGTH");
  add("--force-unit", "force_unit").type("UNIT");
  add("--format", "format").type("NAME");
  add("--grain-columns", "grain_columns").type("NAMES");
  add("--columns", "contact_columns").type("NAMES");
  a.gap.add(command, "--touching", "touching").type("LENGTH");
  add("--y-down", "y_down");
  command.add("--doubled", a.doubled, "merge: " + recipe::help_of(a.sample.at("merge_doubled")))
      .among({"error", "merge"})
      .type("WAY");
}

/// The stresses of a stored field, measured anew.
void measure_field(const MeasureArguments& a) {
  const FieldResult field = io::read_field(a.grains);
  if (field.field.size() == 0)
    throw InputError(a.grains, 0, "is a sample that was not loaded and has no stresses; give the file of a load");
  recipe::Load load;
  read_options(load, a.load.given());
  stress::StressOptions options = load.statistics;
  options.components = {stress::Component::yy, stress::Component::xx, stress::Component::xy,
                        stress::Component::hydrostatic};
  const auto statistics = stress::measure(field.map, field.field, options);
  put(stdout, a.json ? to_json(stress::numbers(statistics, a.curves), 2) + "\n" : stress::to_text(statistics));
}

void add_field_statistics(Options& command, KeyOptions& load) {
  for (const char* key : {"clamp_rows", "leave_out_surface", "leave_out_unloaded", "mean_over_area"}) {
    Option& option = load.add(command, option_name(key), std::string("statistics.") + key);
    option.sentence.insert(0, "Fields: ");
  }
}

void add_statistics(Options& command, MeasureArguments& a) {
  a.measure.add(command, "--border", "border");
  a.measure.add(command, "--load-axis", "load_axis", "deg").type("ANGLE");
  a.measure.add(command, "--seed", "seed");
  command.add("--json", a.json, "Print all statistics as JSON, each as value and error");
  command.add("--curves", a.curves, "With --json: also histograms, distributions and values by grain");
}

}  // namespace

void add_measure(Options& command, int&) {
  const auto a = std::make_shared<MeasureArguments>();
  command
      .add("grains", a->grains,
           "Grains: " + list_of(io::words_of(io::samples::all, &io::SampleFormat::grains_are), "; ") +
               "; or the file of a load (.h5) for its stresses")
      .required()
      .type("GRAINS");
  command
      .add("contacts", a->contacts,
           "Contacts: " + list_of(io::words_of(io::samples::all, &io::SampleFormat::contacts_are), "; ") +
               "; none for a field, or with --touching")
      .type("CONTACTS");
  add_statistics(command, *a);
  add_reading(command, *a);
  add_field_statistics(command, a->load);
  command.work = [a] {
    if (io::stored_kind(a->grains) == "field") return measure_field(*a);
    const bool touches = !a->gap.text("touching").empty();
    if (a->contacts.empty() != touches)
      throw InputError(!touches
                           ? "give the file of contacts after that of the grains, or --touching with the widest gap "
                             "between grains that touch, for example --touching \"0.2 mm\""
                           : "--touching: for grains without a file of contacts; leave out one of the two");
    measure(*a);
  };
}

}  // namespace arenite::app
