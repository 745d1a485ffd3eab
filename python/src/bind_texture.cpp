#include <fmt/core.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "grains/texture/texture.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "recipe/recipe.hpp"

namespace arenite::python {
namespace {

const Keywords& measure_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::MeasureSection>(),
                                 {{"border", "border"}, {"load_axis", "load_axis", "deg"}, {"seed", "seed"}});
  return keywords;
}

const Keywords& grains_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::MeasureSection>(), {{"border", "border"}});
  return keywords;
}

texture::Options options_of(const std::vector<recipe::Given>& given) {
  recipe::MeasureSection section;
  read_keywords(section, given);
  texture::Options options;
  section.apply_to(options);
  return options;
}

py::dict measured(const Packing& packing, bool curves, const std::optional<ArrayLike>& sigma_hyd,
                  const py::kwargs& more) {
  texture::Options options = options_of(measure_keywords().given("measure", more));
  if (sigma_hyd) {
    options.grain_sigma_hyd = to_vector(*sigma_hyd, "sigma_hyd");
    if (options.grain_sigma_hyd.empty())
      throw InputError("sigma_hyd holds no value; give one per grain, or leave it out");
  }
  Call call;
  return to_arrays(call.without_lock([&] { return texture::numbers(texture::measure(packing, options), curves); }));
}

py::dict per_grain(const Packing& packing, const py::kwargs& more) {
  const auto options = options_of(grains_keywords().given("measure_grains", more));
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

using Pair = std::optional<std::pair<Quantity, Quantity>>;

std::optional<Vec2> lengths_of(const Pair& pair, const char* name) {
  if (!pair) return std::nullopt;
  return Vec2{pair->first.si(dimension::length, name), pair->second.si(dimension::length, name)};
}

Packing packing_of_files(const Path& grains, const std::optional<Path>& contacts, const std::string& format,
                         const Pair& box, const Pair& origin, const std::optional<Quantity>& thickness,
                         const std::string& periodic, const std::optional<std::string>& length_unit,
                         const std::optional<std::string>& force_unit, const std::optional<Quantity>& pixel,
                         const std::optional<Path>& materials, const std::string& grain_columns,
                         const std::string& contact_columns, bool y_down, bool merge_doubled) {
  io::SampleOptions o;
  o.format = format;
  o.box = lengths_of(box, "box");
  if (o.box && !(o.box->x > 0 && o.box->y > 0)) throw InputError("box: width and height must be positive");
  o.origin = lengths_of(origin, "origin");
  o.thickness = si(thickness, dimension::length, "thickness");
  if (o.thickness && !(*o.thickness > 0)) throw InputError("thickness: the length of the cylinders must be positive");
  std::tie(o.periodic[0], o.periodic[1]) = periodic_directions(periodic);
  if (length_unit) o.length_unit = io::unit_factor(*length_unit, dimension::length);
  if (force_unit) o.force_unit = io::unit_factor(*force_unit, dimension::force);
  o.pixel = si(pixel, dimension::length, "pixel").value_or(0);
  o.materials = materials;
  o.grain_columns = grain_columns;
  o.contact_columns = contact_columns;
  o.y_down = y_down;
  o.merge_doubled = merge_doubled;
  Call call;
  return call.without_lock([&] { return io::read_sample(grains, contacts.value_or(Path()), o).packing; });
}

}  // namespace

void bind_texture(py::module_& m) {
  def_with_keywords(
      m, "measure", &measured, measure_keywords(),
      "Fabric, forces and stress of a packing as a dict: solid_fraction, rev, coordination (contacts of a "
      "grain), fabric, force, stress, sigma_norm, local_order, quality. Each statistic is {\"value\", "
      "\"error\"}, its standard error. The end of a name is its unit: _N, _Pa, _m, _deg; all other numbers "
      "have none (fractions, ratios, x over the mean of its set). Curves are arrays. `sigma_hyd`: measured "
      "stress of every grain, Pa, NaN if not known, instead of that from its contacts.",
      py::arg("packing"), py::kw_only(), py::arg("curves") = true, py::arg("sigma_hyd") = py::none());
  def_with_keywords(
      m, "measure_grains", &per_grain, grains_keywords(),
      "Statistics of every grain, as writable arrays: considered, rattler (bool), contacts, sigma_hyd (Pa, "
      "tension positive), sigma_norm (over the mean of the considered), psi6.",
      py::arg("packing"));
  m.def("grain_stresses", &stresses_of, py::arg("packing"),
        "Mean stress tensor of every grain over its own volume, from its contacts, bonds and attraction across gaps (T "
        "eq. 1.11), Pa, tension positive, as an array (grain, 2, 2); first index that of the force.");
  m.def("read_packing", &packing_of_files, py::arg("grains"), py::arg("contacts") = py::none(),
        py::arg("format") = "auto", py::kw_only(), py::arg("box") = py::none(), py::arg("origin") = py::none(),
        py::arg("thickness") = py::none(), py::arg("periodic") = "", py::arg("length_unit") = py::none(),
        py::arg("force_unit") = py::none(), py::arg("pixel") = py::none(), py::arg("materials") = py::none(),
        py::arg("grain_columns") = "", py::arg("contact_columns") = "", py::arg("y_down") = false,
        py::arg("merge_doubled") = false,
        "Grains and contacts from files of YADE, LAMMPS, MercuryDPM or CSV, as `arenite measure` reads them. Data "
        "missing in the files: `box` (width, height) and its lower left corner `origin`, `thickness` of the cylinders "
        "(m, or text with a unit), `periodic` (\"x\", \"y\", \"xy\"), units of columns without a unit, `pixel` for "
        "tables in pixels, a table of `materials`, columns of tables without header (\"id,x,y,-,radius\"). `y_down`: y "
        "counts image rows. `merge_doubled`: a contact listed twice is taken once, with the mean of its forces.");
}

}  // namespace arenite::python
