#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <numeric>
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
#include "thermal/imaging/proposed_contacts.hpp"

namespace arenite::app {
namespace {

struct MeasureArguments {
  KeyOptions measure{recipe::every_key<recipe::MeasureSection>()}, load{recipe::every_key<recipe::Load>()};
  std::string grains, contacts, format = "auto", length_unit, force_unit, box, origin, periodic, thickness, materials,
                                doubled = "error";
  std::string grain_columns, contact_columns, pixel, touching;
  bool json = false, curves = false, y_down = false;
};

/// "350 mm" or a bare number in the length unit.
double length_of(const std::string& text, double unit) {
  if (const auto number = io::to_number(text)) return *number * unit;
  return parse_si(text, dimension::length, "mm");
}

std::vector<double> lengths_of(const char* option, const std::string& text, double unit, std::size_t least,
                               std::size_t most) {
  std::vector<double> values;
  for (const auto& part : parts_of(text)) values.push_back(option_value(option, [&] { return length_of(part, unit); }));
  if (values.size() < least || values.size() > most)
    throw InputError(std::string(option) + ": expected " + (least == most ? "" : "two or ") +
                     (most == 3 ? "three" : "two") + " lengths separated by commas, for example \"350 mm,350 mm\"");
  return values;
}

double positive(const char* option, const std::string& text, double unit, const char* what) {
  const double length = option_value(option, [&] { return length_of(text, unit); });
  if (!(length > 0)) throw InputError(std::string(option) + ": " + what + " must be positive");
  return length;
}

io::SampleOptions sample_options(const MeasureArguments& a) {
  io::SampleOptions o;
  o.format = a.format;
  o.grain_columns = a.grain_columns;
  o.contact_columns = a.contact_columns;
  if (!a.length_unit.empty())
    o.length_unit = option_value("--length-unit", [&] { return io::unit_factor(a.length_unit, dimension::length); });
  if (!a.force_unit.empty())
    o.force_unit = option_value("--force-unit", [&] { return io::unit_factor(a.force_unit, dimension::force); });
  const double unit = o.length_unit.value_or(1);
  if (!a.pixel.empty()) o.pixel = positive("--pixel", a.pixel, unit, "the width of a pixel on the sample");
  if (!a.box.empty()) {
    const auto box = lengths_of("--box", a.box, unit, 2, 3);
    if (!(box[0] > 0) || !(box[1] > 0)) throw InputError("--box: width and height must be positive");
    o.box = Vec2{box[0], box[1]};
    if (box.size() == 3) o.tilt = box[2];
  }
  if (!a.origin.empty()) {
    const auto corner = lengths_of("--origin", a.origin, unit, 2, 2);
    o.origin = Vec2{corner[0], corner[1]};
  }
  o.periodic[0] = a.periodic.find('x') != std::string::npos;
  o.periodic[1] = a.periodic.find('y') != std::string::npos;
  if (!a.thickness.empty()) o.thickness = positive("--thickness", a.thickness, unit, "the length of the cylinders");
  if (!a.materials.empty()) o.materials = a.materials;
  o.y_down = a.y_down;
  o.merge_doubled = a.doubled == "merge";
  return o;
}

/// Where no contacts are given: those between surfaces no further apart than the gap that was asked for, without
/// forces.
void propose_contacts(const MeasureArguments& a, io::Sample& sample, texture::Options& options) {
  imaging::ContactTolerance tolerance;
  tolerance.floor = 1;
  tolerance.pixel =
      positive("--touching", a.touching, sample_options(a).length_unit.value_or(1), "the widest gap of a contact");
  const std::vector<double>& radius = sample.packing.grains.radius;
  const double mean_radius = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
  if (tolerance.pixel > mean_radius)
    throw InputError(fmt::format(
        "--touching: {} is wider than the mean radius of the grains, {:.4g} m; grains so far apart do not touch",
        a.touching, mean_radius));
  sample.packing.contacts = imaging::propose_contacts(sample.packing.grains, sample.packing.domain, {}, tolerance);
  options.rattler_contacts = 0;
  sample.notes.push_back("Grains are taken to touch where their surfaces are within " + a.touching +
                         " of each other; forces are not known, so statistics of forces are left out.");
}

void measure(const MeasureArguments& a) {
  io::Sample sample = io::read_sample(a.grains, a.contacts, sample_options(a));
  recipe::MeasureSection section;
  read_options(section, a.measure.given());
  texture::Options options;
  section.apply_to(options);
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

void add_units(Options& command, MeasureArguments& a) {
  command.add("--length-unit", a.length_unit, "Unit of lengths in columns without a unit, e.g. mm; default m")
      .type("UNIT");
  command.add("--pixel", a.pixel, "Width of a pixel on the sample, e.g. \"1.6 mm\", for a table in pixels")
      .type("LENGTH");
  command.add("--force-unit", a.force_unit, "Unit of forces in columns without a unit, e.g. kN; default N")
      .type("UNIT");
}

void add_frame(Options& command, MeasureArguments& a) {
  command
      .add("--box", a.box,
           "Width and height of the sample, and tilt of a sheared periodic cell, e.g. \"350 mm,350 mm\"")
      .type("LX,LY[,tilt]");
  command
      .add("--origin", a.origin,
           "Lower left corner of the box; default 0,0, or around the centres if they lie elsewhere")
      .type("X,Y");
  command.add("--periodic{xy}", a.periodic, "Periodic boundaries; --periodic=x or --periodic=y for one direction");
  command.add("--thickness", a.thickness, "Out-of-plane length of the cylinders, e.g. \"60 mm\"; stresses need it")
      .type("LENGTH");
  command
      .add("--materials", a.materials,
           "Table of materials (material,name,density,...) or of the material of each grain (id,material)")
      .type("FILE");
}

void add_reading(Options& command, MeasureArguments& a) {
  auto formats = io::words_of(io::samples::all, &io::SampleFormat::name);
  formats.insert(formats.begin(), "auto");
  command.add("--format", a.format, "Format of the files; auto: by their first line").among(formats).type("NAME");
  command.add("--grain-columns", a.grain_columns, "Columns of a grain table without header, e.g. \"id,x,y,-,radius\"")
      .type("NAMES");
  command
      .add("--columns", a.contact_columns,
           "Columns of a contact table without header, e.g. \"i,j,-,ft [N],fn [N]\" or \"i,j,fx,fy\"; or of a LAMMPS "
           "dump with computes other than those in docs/measure.md, e.g. \"-,patom1,patom2,fx,fy,p1,p2\"")
      .type("NAMES");
  command
      .add("--touching", a.touching,
           "Without a file of contacts: widest gap between the surfaces of grains that are taken to touch; forces are "
           "then not known")
      .type("LENGTH");
  command.add("--y-down", a.y_down, "y counts image rows, which point down; y is flipped, fn and ft are kept");
  command
      .add("--doubled", a.doubled,
           "What to do with a contact listed twice: error, or merge (taken once, with the mean of its forces)")
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
  add_frame(command, *a);
  add_units(command, *a);
  add_reading(command, *a);
  add_field_statistics(command, a->load);
  command.work = [a] {
    if (io::stored_kind(a->grains) == "field") return measure_field(*a);
    if (a->contacts.empty() == a->touching.empty())
      throw InputError(a->touching.empty()
                           ? "give the file of contacts after that of the grains, or --touching with the widest gap "
                             "between grains that touch, for example --touching \"0.2 mm\""
                           : "--touching: for grains without a file of contacts; leave out one of the two");
    measure(*a);
  };
}

}  // namespace arenite::app
