#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/formula.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/loading.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "model/field_quantities.hpp"
#include "module.hpp"
#include "report/figures/grains/grain_values.hpp"
#include "solid/stress/sample_means.hpp"
#include "statistics/numbers_text.hpp"
#include "statistics/written.hpp"

/// Numbers that pictures are drawn from, of grains and of nodes, and how numbers are written.
namespace arenite::python {
namespace {

namespace figures = report::figures;

/// Vectors as rows.
template <int D> py::array_t<double> rows_of_vectors(const std::vector<Vec<D>>& values) {
  std::vector<double> flat;
  for (const Vec<D>& v : values)
    for (int axis = 0; axis < D; ++axis) flat.push_back(v[axis]);
  return taken_over(std::move(flat), {static_cast<py::ssize_t>(values.size()), D});
}

template <int D> using ManyPackings = std::vector<const PackingIn<D>*>;

template <int D> auto ways_of(Call& call, const ManyPackings<D>& packings, const std::vector<double>& shear_strain) {
  if (!shear_strain.empty() && shear_strain.size() != packings.size())
    throw refusal("there are {} packings and {} shear strains; give as many", packings.size(), shear_strain.size());
  std::vector<texture::ShearedIn<D>> states;
  for (std::size_t k = 0; k < packings.size(); ++k)
    states.push_back({packings[k], shear_strain.empty() ? 0 : shear_strain[k]});
  return call.without_lock([&] { return texture::displacements(states); });
}

template <int D> py::list displacements_of(const ManyPackings<D>& packings, const std::vector<double>& shear_strain) {
  Call call;
  py::list list;
  for (const auto& way : ways_of<D>(call, packings, shear_strain)) list.append(rows_of_vectors<D>(way));
  return list;
}

template <int D>
py::list sizes_of_displacements(const ManyPackings<D>& packings, const std::vector<double>& shear_strain) {
  Call call;
  py::list list;
  for (const auto& way : ways_of<D>(call, packings, shear_strain))
    list.append(taken_over(mapped(way, [](const Vec<D>& one) { return norm(one); })));
  return list;
}

template <class Packing_> py::array_t<double> values_of_grains(const Packing_& packing, const std::string& name) {
  Call call;
  return taken_over(call.without_lock([&] { return texture::values_of(packing, name); }));
}

template <int D>
py::array_t<double> values_in_stage(const StageResultIn<D>& stage, const SnapshotIn<D>& state,
                                    const std::string& name) {
  Call call;
  return taken_over(call.without_lock([&] { return figures::grain_values(stage, state, name); }));
}

template <class Packing_>
py::array_t<double> mobilisations_of(const Packing_& packing, std::optional<double> friction) {
  Call call;
  return taken_over(call.without_lock([&] { return texture::mobilisations(packing, friction); }));
}

/// A quantity of nodes by the arrays of anything that has the stored ones, as a Field has.
py::array_t<double> field_values(const py::object& field, const std::string& name) {
  using Stored = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const auto array_of = [&](std::string_view quantity) {
    return Stored::ensure(field.attr(std::string(field_quantity(quantity).name).c_str()));
  };
  const Stored like = array_of("yy");
  const auto size = static_cast<std::size_t>(like.size());
  auto values = evaluated(field_quantity(name).formula, size, [&](std::string_view id) {
    const Stored array = array_of(id);
    return std::vector<double>(array.data(), array.data() + array.size());
  });
  return taken_over(std::move(values), {like.shape(), like.shape() + like.ndim()});
}

void bind_numbers_of_grains(py::module_& m) {
  const char
      *values =
          "A number of every grain: x, y, size (diameter, m), coordination (contacts), pressure, deviator "
          "(half the difference of the principal stresses, of spheres sqrt(3 J_2), Pa), stress (over its mean away "
          "from the border), friction (mean "
          "|F_t|/F_n of the contacts that push), speed, vx, vy (m/s), spin (rad/s).",
      *mobilised =
          "Mean |F_t|/(mu F_n) of the contacts of every grain that push; of |F_t|/F_n where mu is not "
          "given; 0 without friction.",
      *ways =
          "Displacements of grains since the first of these states, m, (n, 2) for each, of spheres (n, 3); "
          "without the shear of a cell whose strains are given. In a periodic cell grains must not move "
          "farther than half a cell between two states.";
  m.def("grain_values", &values_of_grains<Packing>, py::arg("packing"), py::arg("name"), values);
  m.def("grain_values", &values_of_grains<PackingIn<3>>, py::arg("packing"), py::arg("name"));
  m.def("_sizes_of_displacements", &sizes_of_displacements<2>, py::arg("packings"), py::arg("shear_strain"),
        "How far grains have gone since the first of these states, m, as `displacements`.");
  m.def("_sizes_of_displacements", &sizes_of_displacements<3>, py::arg("packings"), py::arg("shear_strain"));
  m.def("_grain_values_of_state", &values_in_stage<2>, py::arg("stage"), py::arg("state"), py::arg("name"),
        "The same of a stored state of a stage, also what takes its states before or how it is measured; empty where "
        "it is not told.");
  m.def("_grain_values_of_state", &values_in_stage<3>, py::arg("stage"), py::arg("state"), py::arg("name"));
  m.def("mobilisation", &mobilisations_of<Packing>, py::arg("packing"), py::arg("friction") = py::none(), mobilised);
  m.def("mobilisation", &mobilisations_of<PackingIn<3>>, py::arg("packing"), py::arg("friction") = py::none());
  m.def("displacements", &displacements_of<2>, py::arg("packings"), py::arg("shear_strain") = std::vector<double>{},
        ways);
  m.def("displacements", &displacements_of<3>, py::arg("packings"), py::arg("shear_strain") = std::vector<double>{});
  m.def(
      "_mean_radius", [](const Packing& packing) { return 0.5 * packing.grains.mean_diameter(); }, py::arg("packing"),
      "That of its grains, m.");
  m.def(
      "_mean_radius", [](const PackingIn<3>& packing) { return 0.5 * packing.grains.mean_diameter(); },
      py::arg("packing"));
  m.def("_at_time", &fields::at_time, py::arg("time"), py::arg("values"), py::arg("t"),
        "Values at a time between two rows, straight from one to the next; those of the first and last row beyond.");
  m.def(
      "_rotations",
      [](const std::vector<const Packing*>& packings) {
        py::list list;
        for (auto& turned : texture::rotations(packings)) list.append(taken_over(std::move(turned)));
        return list;
      },
      py::arg("packings"), "Rotations of grains since the first of these states, rad, an array for each.");
}

void bind_pictures_of_fields(py::module_& m) {
  m.def(
      "_field_quantities",
      [] {
        py::dict list;
        for (const FieldQuantity& q : field_quantities())
          list[py::str(std::string(q.name))] = py::make_tuple(q.symbol, q.unit, q.is_magnitude);
        return list;
      },
      "What a picture of a field may show: symbol, unit and whether it is a magnitude, by name.");
  m.def("_field_values", &field_values, py::arg("field"), py::arg("name"),
        "That quantity on all nodes, from the arrays of a field.");
  m.def(
      "_field_mean",
      [](const FieldResult& field, const std::string& name) {
        return stress::SampleMeans(field).of(field_quantity(name));
      },
      py::arg("field"), py::arg("name"), "Its mean over the sample, as the statistics of the field take it.");
}

void bind_written(py::module_& m) {
  m.def(
      "_scale_of",
      [](double largest, const std::string& unit) {
        const statistics::Scale scale = statistics::scale_of(std::abs(largest), unit);
        return py::make_tuple(scale.factor, scale.unit);
      },
      py::arg("largest"), py::arg("unit"),
      "The factor and the unit with its prefix under which such numbers are written.");
  m.def(
      "_with_error",
      [](double value, double error) {
        std::string text = statistics::with_error({value, error});
        if (const auto sign = text.find("+-"); sign != text.npos) text.replace(sign, 2, "\u00b1");
        return text;
      },
      py::arg("value"), py::arg("error"),
      "\"0.842 \u00b1 0.003\", as texts have it; without an error the value alone.");
}

}  // namespace

void bind_drawn_numbers(py::module_& m) {
  bind_numbers_of_grains(m);
  bind_pictures_of_fields(m);
  bind_written(m);
}

}  // namespace arenite::python
