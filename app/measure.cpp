#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "commands.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "grains/texture/texture.hpp"
#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "io/sample/formats.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "recipe/recipe.hpp"
#include "report/page.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"
#include "statistics/numbers_text.hpp"
#include "workflow/measure_spheres.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {
namespace {

/// How contacts are found that no file gives.
struct ContactGap {
  std::optional<double> touching;  ///< m
};
void declare(ParameterVisitor& v, ContactGap& gap) {
  v.number({"touching",
            "Without a file of contacts: widest gap between the surfaces of grains that are taken to touch (of spheres "
            "unless given 0); forces are then not known."},
           gap.touching, "mm", range::positive);
}

struct MeasureArguments {
  KeyOptions measure{recipe::every_key<Measuring>()}, load{recipe::every_key<recipe::Load>()};
  KeyOptions sample{recipe::every_key<io::SampleOptions>()}, gap{recipe::every_key<ContactGap>()};
  std::string grains, contacts, periodic, out, doubled = "error";
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

/// Says in which unit lengths of the command line were taken that have none of their own and none by --length-unit:
/// the files may be in mm.
void tell_of_bare_lengths(const MeasureArguments& a, std::vector<std::string>& notes) {
  if (!a.sample.text("length_unit").empty()) return;
  std::vector<std::string> bare;
  for (const char* key : {"box", "origin", "thickness", "pixel"})
    if (std::ranges::any_of(split_commas(a.sample.text(key)),
                            [](const std::string& part) { return io::to_number(part).value_or(0) != 0; }))
      bare.push_back(option_name(key));
  if (!bare.empty())
    notes.push_back(
        fmt::format("{}: lengths without a unit were taken in m; write them with one, for example --box \"60 "
                    "mm,40 mm\", or give --length-unit.",
                    list_of(bare)));
}

/// Where no contacts are given: those between surfaces no further apart than the gap that was asked for, without
/// forces; what is said of them.
template <int D> std::string propose_contacts(const MeasureArguments& a, io::SampleIn<D>& sample) {
  ContactGap gap;
  read_options(gap, a.gap.given(bare_length(a)));
  return workflow::propose_contacts(sample, gap.touching.value_or(0), a.gap.text("touching"));
}

void measure(const MeasureArguments& a, io::Sample sample) {
  texture::Options options;
  read_options(static_cast<Measuring&>(options), a.measure.given());
  if (!a.out.empty())
    throw InputError(a.grains, 0,
                     "holds disks, whose numbers are printed; --out makes files of spheres (in Python, "
                     "arenite.page(read_packing(...), \"page.html\") makes a page of disks)");
  if (a.contacts.empty()) {
    if (a.gap.text("touching").empty())
      throw InputError(
          "give the file of contacts after that of the grains, or --touching with the widest gap between grains that "
          "touch, for example --touching \"0.2 mm\"");
    sample.notes.push_back(propose_contacts(a, sample) + ".");
  }
  options.doubled_rows = sample.doubled_rows;
  texture::Texture t = texture::measure(sample.packing, options);
  t.notes.insert(t.notes.begin(), sample.notes.begin(), sample.notes.end());
  if (sample.doubled_rows > 0)
    t.notes.insert(t.notes.begin(), std::to_string(sample.doubled_rows) +
                                        " rows repeat a contact that is already listed, and were merged with it.");
  put(stdout, a.json ? to_json(texture::numbers(t, a.curves), 2) + "\n" : texture::to_text(t));
}

/// Of the files, and of what was made of them as they were read.
std::string hash_of(const MeasureArguments& a, const Numbers& numbers) {
  HashBuilder hash;
  for (const auto& path : {a.grains, a.contacts})
    if (!path.empty()) hash.add("file", io::read_file(path));
  return hash.add("numbers", to_json(numbers)).hex();
}

void measure(const MeasureArguments& a, io::SampleIn<3> sample) {
  Measuring how;
  read_options(how, a.measure.given());
  if (a.contacts.empty()) sample.notes.push_back(propose_contacts(a, sample) + ".");
  SphereResult stage = workflow::measured_stage(std::move(sample), how, a.grains);
  stage.provenance.input_hash = hash_of(a, stage.texture);
  Numbers numbers = stage.texture;
  if (!a.json) erase(numbers, Trait::detail);
  if (!a.curves) erase(numbers, Trait::curve);
  put(stdout, a.json ? to_json(numbers, 2) + "\n" : arenite::to_text(numbers));
  if (a.out.empty()) return;
  const std::string name = io::stage_file_name(1, stage.name, stage.provenance.input_hash);
  const workflow::ResultFolder folder(a.out, {name});
  const std::filesystem::path page = folder / "report.html";
  io::write_stage(folder / name, stage);
  report::write_page(page, {.title = stage.provenance.title, .spheres = {&stage, 1}});
  if (!a.json) print("\nresult: {}\npage:   {}\n", (folder / name).string(), page.string());
}

void add_reading(Options& command, MeasureArguments& a) {
  const auto add = [&](const char* name, const char* key) -> Option& { return a.sample.add(command, name, key); };
  add("--box", "box").type("LX,LY[,LZ][,tilt]");
  add("--origin", "origin").type("X,Y[,Z]");
  command.add("--periodic{all}", a.periodic,
              recipe::help_of(a.sample.at("periodic")) + "; --periodic=x or --periodic=y for one direction");
  add("--dimension", "dimension").type("WORD");
  add("--thickness", "thickness").type("LENGTH");
  add("--materials", "materials").type("FILE");
  add("--length-unit", "length_unit").type("UNIT");
  add("--pixel", "pixel").type("LENGTH");
  add("--force-unit", "force_unit").type("UNIT");
  add("--format", "format").type("NAME");
  add("--grain-columns", "grain_columns").type("NAMES");
  add("--columns", "contact_columns").type("NAMES");
  command.add("--out", a.out, "Folder for the result and the page of a sample of spheres, as `arenite run` writes them")
      .type("DIR");
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
               "; none for a field, with --touching, or for spheres that touch where they overlap")
      .type("CONTACTS");
  add_statistics(command, *a);
  add_reading(command, *a);
  add_field_statistics(command, a->load);
  command.work = [a] {
    if (io::stored_kind(a->grains) == "field") return measure_field(*a);
    if (!a->contacts.empty() && !a->gap.text("touching").empty())
      throw InputError("--touching: for grains without a file of contacts; leave out one of the two");
    std::visit(
        [&](auto&& sample) {
          tell_of_bare_lengths(*a, sample.notes);
          measure(*a, std::move(sample));
        },
        io::read_any_sample(a->grains, a->contacts, sample_options(*a)));
  };
}

}  // namespace arenite::app
