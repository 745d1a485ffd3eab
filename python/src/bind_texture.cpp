#include <fmt/core.h>
#include <pybind11/stl.h>

#include <utility>
#include <variant>

#include "arrays.hpp"
#include "calls.hpp"
#include "file_notes.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "recipe/recipe.hpp"
#include "workflow/measure_spheres.hpp"

namespace arenite::python {
namespace {

const Keywords& measure_keywords() {
  static const Keywords keywords(recipe::every_key<Measuring>(),
                                 {{"border", "border"}, {"load_axis", "load_axis", "deg"}, {"seed", "seed"}});
  return keywords;
}

const Keywords& grains_keywords() {
  static const Keywords keywords(recipe::every_key<Measuring>(), {{"border", "border"}});
  return keywords;
}

Measuring measuring_of(const std::vector<recipe::Given>& given) {
  Measuring how;
  read_keywords(how, given);
  return how;
}

Numbers numbers_of(const Packing& packing, const Measuring& how, bool curves, const std::optional<ArrayLike>& sigma_hyd,
                   Call& call) {
  texture::Options options;
  static_cast<Measuring&>(options) = how;
  if (sigma_hyd) {
    options.grain_sigma_hyd = to_vector(*sigma_hyd, "sigma_hyd");
    if (options.grain_sigma_hyd.empty())
      throw InputError("sigma_hyd holds no value; give one per grain, or leave it out");
  }
  return call.without_lock([&] { return texture::numbers(texture::measure(packing, options), curves); });
}

Numbers numbers_of(const PackingIn<3>& packing, const Measuring& how, bool /*curves*/,
                   const std::optional<ArrayLike>& sigma_hyd, Call& call) {
  if (sigma_hyd) throw InputError("sigma_hyd is of disks; spheres are measured by their contacts, so leave it out");
  return call.without_lock([&] { return texture::measure_spheres(packing, texture::sphere_options(packing, how)); });
}

using EitherPacking = std::variant<const Packing*, const PackingIn<3>*>;

py::dict measured(const EitherPacking& packing, bool curves, const std::optional<ArrayLike>& sigma_hyd,
                  const py::kwargs& more) {
  const Measuring how = measuring_of(measure_keywords().given("measure", more));
  Call call;
  return to_arrays(
      std::visit([&](const auto* any) { return numbers_of(*any, how, curves, sigma_hyd, call); }, packing));
}

py::dict per_grain(const Packing& packing, const py::kwargs& more) {
  texture::Options options;
  static_cast<Measuring&>(options) = measuring_of(grains_keywords().given("measure_grains", more));
  Call call;
  auto t = call.without_lock([&] { return texture::measure(packing, options).per_grain; });
  py::dict d;
  d["considered"] = taken_over_as_bool(std::move(t.considered));
  d["rattler"] = taken_over_as_bool(std::move(t.rattler));
  d["contacts"] = taken_over(std::move(t.contacts));
  d["sigma_hyd"] = taken_over(std::move(t.sigma_hyd));
  d["sigma_norm"] = taken_over(std::move(t.sigma_norm));
  d["psi6"] = taken_over(std::move(t.psi6));
  return d;
}

py::array_t<double> stresses_of(const Packing& packing) {
  Call call;
  const auto stresses = call.without_lock([&] { return texture::grain_stresses(packing); });
  std::vector<double> values;
  for (const Tensor2& s : stresses) values.insert(values.end(), {s.xx, s.xy, s.yx, s.yy});
  return taken_over(std::move(values), {static_cast<py::ssize_t>(stresses.size()), 2, 2});
}

const Keywords& sample_keywords() {
  static const Keywords keywords(recipe::every_key<io::SampleOptions>(), {{"format", "format", "", true},
                                                                          {"box", "box"},
                                                                          {"origin", "origin"},
                                                                          {"dimension", "dimension"},
                                                                          {"thickness", "thickness"},
                                                                          {"periodic", "periodic"},
                                                                          {"length_unit", "length_unit"},
                                                                          {"force_unit", "force_unit"},
                                                                          {"pixel", "pixel"},
                                                                          {"materials", "materials"},
                                                                          {"grain_columns", "grain_columns"},
                                                                          {"contact_columns", "contact_columns"},
                                                                          {"y_down", "y_down"},
                                                                          {"merge_doubled", "merge_doubled"}});
  return keywords;
}

using AnyPacking = std::variant<Packing, PackingIn<3>>;

AnyPacking packing_of(io::Sample& sample, bool /*has_contacts*/) { return std::move(sample.packing); }
AnyPacking packing_of(io::SampleIn<3>& sample, bool has_contacts) {
  if (!has_contacts) workflow::propose_contacts(sample, 0, "");
  return std::move(sample.packing);
}

OnePacking packing_of_files(const Path& grains, const std::optional<Path>& contacts, const std::string& format,
                            const py::kwargs& more) {
  auto given = sample_keywords().given("read_packing", more);
  given.push_back(sample_keywords().given("format", py::str(format)));
  io::SampleOptions options;
  read_keywords(options, given);
  Call call;
  std::vector<std::string> notes;
  OnePacking packing(py::cast(call.without_lock([&] {
    io::AnySample sample = io::read_any_sample(grains, contacts.value_or(Path()), options);
    AnyPacking read = std::visit([&](auto& any) { return packing_of(any, contacts.has_value()); }, sample);
    notes = std::visit([](const auto& any) { return any.notes; }, sample);
    return read;
  })));
  keep_notes(packing, notes);
  warn_of_notes(notes);
  return packing;
}

}  // namespace

void bind_texture(py::module_& m) {
  def_with_keywords(
      m, "measure", &measured, measure_keywords(),
      "Fabric, forces and stress of disks or spheres as a dict: solid_fraction, rev, coordination (contacts of a "
      "grain), fabric, force, stress, quality, and of disks sigma_norm and local_order; of spheres it is what their "
      "own `measure` gives, and rattlers are judged by whether contacts have friction. Each statistic is {\"value\", "
      "\"error\"}, its standard error. The end of a name is its unit: _N, _Pa, _m, _deg; all other numbers "
      "have none (fractions, ratios, x over the mean of its set). Curves are arrays. Of disks alone: `curves`, whether "
      "those of distributions are there; `sigma_hyd`, measured stress of every grain, Pa, NaN if not known, instead of "
      "that from its contacts.",
      py::arg("packing").none(false), py::kw_only(), py::arg("curves") = true, py::arg("sigma_hyd") = py::none());
  def_with_keywords(
      m, "measure_grains", &per_grain, grains_keywords(),
      "Statistics of every grain, as writable arrays: considered, rattler (bool), contacts, sigma_hyd (Pa, "
      "tension positive), sigma_norm (over the mean of the considered), psi6.",
      py::arg("packing"));
  m.def("grain_stresses", &stresses_of, py::arg("packing"),
        "Mean stress tensor of every grain over its own volume, from its contacts, bonds and attraction across gaps (T "
        "eq. 1.11), Pa, tension positive, as an array (grain, 2, 2); first index that of the force.");
  def_with_keywords(
      m, "read_packing", &packing_of_files, sample_keywords(),
      "Grains and contacts from files of YADE, LAMMPS, MercuryDPM or CSV, as `arenite measure` reads them; "
      "the keywords give what the files lack. Quantities in SI, or text with a unit. Disks are a Packing, spheres a "
      "SpherePacking; spheres without a file of contacts touch where they overlap. What the files do not say, or say "
      "otherwise than is taken, is warned of (FileWarning) and kept in `notes`.",
      py::arg("grains"), py::arg("contacts") = py::none(), py::arg("format") = io::SampleOptions{}.format);
}

}  // namespace arenite::python
