#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "calls.hpp"
#include "file_notes.hpp"
#include "keywords.hpp"
#include "load_keywords.hpp"
#include "model/voxel_map.hpp"
#include "model/voxel_quantities.hpp"
#include "module.hpp"
#include "phase_words.hpp"
#include "solid/grid/label_grains.hpp"
#include "solid/stress/sample_means.hpp"
#include "workflow/load_voxels.hpp"
#include "workflow/read_map.hpp"

namespace arenite::python {
namespace {

VoxelMap voxels_of(const ArrayLike& phase, const std::optional<ArrayLike>& grain, const Quantity& dx) {
  const auto values = whole_numbers(phase, 0, 2, "phase (0 void, 1 matrix, 2 particle)", 3);
  const auto shape = py::array(phase).request().shape;
  VoxelMap map = make_voxel_map(static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0]),
                                dx.si(dimension::length, "dx"));
  std::ranges::transform(values, map.phase.begin(), [](std::int32_t value) { return static_cast<Phase>(value); });
  if (grain && py::array(*grain).request().shape != shape)
    throw InputError("grain: the labels must have the voxel map's shape");
  if (grain) {
    map.grain = whole_numbers(*grain, -1, static_cast<std::int32_t>(map.size()) - 1, "grain", 3);
    const std::int32_t last = map.grain.empty() ? -1 : *std::ranges::max_element(map.grain);
    map.grain_class.assign(static_cast<std::size_t>(last + 1), GrainClass::none);
  } else {
    grid::label_grains(map);
  }
  check(map);
  return map;
}

const Keywords& voxel_map_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::MapSection>(), {{"file", "file", "", true},
                                                                           {"dx", "dx", "", true},
                                                                           {"labels", "labels", "", true},
                                                                           {"phases", "phases", "", true},
                                                                           {"smoothing", "smoothing"},
                                                                           {"periodic", "periodic"},
                                                                           {"voxels", "voxels"},
                                                                           {"box", "box"},
                                                                           {"dataset", "dataset"},
                                                                           {"label_dataset", "label_dataset"}});
  return keywords;
}

VoxelMap voxel_map_in(const Path& file, const std::optional<Quantity>& dx, const Path& labels, const PhaseWords& phases,
                      const py::kwargs& more) {
  auto given = voxel_map_keywords().given("read_voxel_map", more);
  given.push_back(voxel_map_keywords().given("file", py::str(file.string())));
  given.push_back(voxel_map_keywords().given("labels", py::str(labels.string())));
  given.push_back(voxel_map_keywords().given("phases", py::str(text_of(phases))));
  if (dx) given.push_back(voxel_map_keywords().given("dx", *dx));
  recipe::MapSection map;
  map.dimension = 3;
  read_keywords(map, given);
  std::vector<std::string> notes = workflow::idle_keys(map);
  Call call;
  auto read = call.without_lock(
      [&] { return workflow::read_voxels(map, [&](const std::string& note) { notes.push_back(note); }); });
  warn_of_notes(notes);
  return read;
}

VoxelResult loaded_voxels(const VoxelMap& map, const std::string& loading, int threads, const Progress& progress,
                          const py::kwargs& more) {
  const int members = threads_given(threads);
  const recipe::Load load = load_of("load_voxels", loading, more);
  Call call;
  auto result = call.without_lock([&] {
    const auto watch = [&](const statics::Progress& at) {
      call.tell(progress, at.share, load.name);
      return !call.asked_to_stop();
    };
    return workflow::apply_load(load, map, watch, nullptr, {}, members);
  });
  return result ? std::move(*result) : VoxelResult{};
}

template <class T>
py::array_t<T> volume_view(const std::vector<T>& values, int depth, int height, int width, const py::object& owner) {
  return shaped_view<T, 3>(values, {depth, height, width}, owner);
}

const VoxelQuantity& quantity_named(const std::string& name) {
  const auto& list = voxel_quantities();
  const auto found = std::ranges::find(list, name, &VoxelQuantity::name);
  if (found == list.end()) throw py::key_error(name);
  return *found;
}

py::array_t<double> voxel_values(const VoxelResult& sample, const std::string& name) {
  const VoxelQuantity& quantity = quantity_named(name);
  const VoxelStress& field = sample.field;
  std::vector<double> values(field.size());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = quantity.of(field, k);
  return taken_over(std::move(values), {field.depth, field.height, field.width});
}

py::dict space_cracks_of(const py::object& self) {
  const auto& cracks = self.cast<const VoxelResult&>().cracks;
  py::dict d;
  const auto add = [&]<class T>(const char* name, T SpaceCrack::*member) {
    d[name] = member_view(cracks, member, self);
  };
  add.operator()<float>("x", &SpaceCrack::x);
  add.operator()<float>("y", &SpaceCrack::y);
  add.operator()<float>("z", &SpaceCrack::z);
  add.operator()<std::uint8_t>("type", &SpaceCrack::type);
  add.operator()<double>("strain", &SpaceCrack::strain);
  add.operator()<std::int32_t>("along_x", &SpaceCrack::along_x);
  add.operator()<std::int32_t>("along_y", &SpaceCrack::along_y);
  add.operator()<std::int32_t>("along_z", &SpaceCrack::along_z);
  return d;
}

void def_component(py::class_<VoxelResult>& c, const char* name, std::vector<float> VoxelStress::*member,
                   const char* sentence) {
  c.def_property_readonly(
      name,
      [member](const py::object& self) {
        const VoxelStress& field = self.cast<const VoxelResult&>().field;
        return volume_view(field.*member, field.depth, field.height, field.width, self);
      },
      sentence);
}

void bind_voxel_map(py::module_& m) {
  py::class_<VoxelMap>(m, "VoxelMap", "A sample in space, cut into voxels; arrays are (depth, height, width), z first.")
      .def(py::init(&voxels_of), py::arg("phase"), py::arg("grain") = py::none(), py::kw_only(), py::arg("dx"),
           "A map from your own data, which are copied: `phase` is 0 (void), 1 (matrix) or 2 (particle), `grain` "
           "numbers the particles from 0, -1 elsewhere (connected particles if not given), `dx` is the side of a voxel "
           "(m, or text with a unit).")
      .def_readonly("width", &VoxelMap::width, "Voxels along x.")
      .def_readonly("height", &VoxelMap::height, "Voxels along y.")
      .def_readonly("depth", &VoxelMap::depth, "Voxels along z.")
      .def_readonly("dx", &VoxelMap::dx, "Side of a voxel, m.")
      .def_readonly("has_length", &VoxelMap::has_length, "False where nobody said how long a voxel is: `dx` is 1 then.")
      .def_property_readonly(
          "phase",
          [](const py::object& self) {
            const auto& map = self.cast<const VoxelMap&>();
            py::array_t<std::uint8_t> array({map.depth, map.height, map.width},
                                            reinterpret_cast<const std::uint8_t*>(map.phase.data()), self);
            array.attr("setflags")(py::arg("write") = false);
            return array;
          },
          "0 void, 1 matrix, 2 particle; uint8, (depth, height, width).")
      .def_property_readonly(
          "grain",
          [](const py::object& self) {
            const auto& map = self.cast<const VoxelMap&>();
            return volume_view(map.grain, map.depth, map.height, map.width, self);
          },
          "Number of the grain, -1 outside grains; int32, (depth, height, width).")
      .def("__repr__", [](const VoxelMap& map) {
        return "<arenite.VoxelMap " + std::to_string(map.width) + " x " + std::to_string(map.height) + " x " +
               std::to_string(map.depth) + ">";
      });
}

void bind_voxel_result(py::module_& m) {
  py::class_<VoxelResult> result(m, "VoxelResult", "A sample in space under load.");
  result.def_readonly("name", &VoxelResult::name, "Name of the load.")
      .def_readonly("converged", &VoxelResult::converged, "Whether equilibrium was found.")
      .def_readonly("outcome", &VoxelResult::outcome, "How it ended, in words.")
      .def_readonly("map", &VoxelResult::map, "The sample.")
      .def_property_readonly(
          "numbers", [](const VoxelResult& r) { return to_python(r.numbers); },
          "Modulus, forces, statistics by phase, effective stiffness; as `arenite load --json` prints them.")
      .def_property_readonly(
          "convergence",
          [](const py::object& self) { return columns_of(self.cast<const VoxelResult&>().convergence, self); },
          "iteration, residual (relative).")
      .def_property_readonly(
          "curve", [](const py::object& self) { return columns_of(self.cast<const VoxelResult&>().curve, self); },
          "Of a test to failure: strain, stress, work, elastic and released energy, broken bonds; `curve_units` has "
          "their units.")
      .def_property_readonly(
          "curve_units", [](const VoxelResult& r) { return history_units(r.curve); },
          "Unit of every column of `curve`; \"1\": none.")
      .def_property_readonly(
          "cracks", &space_cracks_of,
          "Broken bonds in the order of breaking: x, y, z (m, float32) of the middle, type (1 matrix, "
          "2 interface, 3 particle), strain of the sample, along_x, along_y, along_z (voxels).")
      .def_property_readonly(
          "damage",
          [](const py::object& self) {
            const VoxelStress& field = self.cast<const VoxelResult&>().field;
            return field.damage.empty() ? py::object(py::none())
                                        : volume_view(field.damage, field.depth, field.height, field.width, self);
          },
          "Share of the bonds of every voxel that broke; float32, (depth, height, width); None but for tests to "
          "failure.")
      .def_property_readonly(
          "provenance", [](const VoxelResult& r) { return to_python(r.provenance); },
          "Provenance: version, stage, input_hash, recipe, seed, kernel, options.");
  const std::pair<const char*, std::vector<float> VoxelStress::*> stresses[] = {
      {"sigma_xx", &VoxelStress::xx}, {"sigma_yy", &VoxelStress::yy}, {"sigma_zz", &VoxelStress::zz},
      {"sigma_yz", &VoxelStress::yz}, {"sigma_xz", &VoxelStress::xz}, {"sigma_xy", &VoxelStress::xy}};
  for (const auto& [name, member] : stresses)
    def_component(result, name, member, "Stress of every voxel, Pa; float32, (depth, height, width).");
  const std::pair<const char*, std::vector<float> VoxelStress::*> displacements[] = {
      {"u_x", &VoxelStress::ux}, {"u_y", &VoxelStress::uy}, {"u_z", &VoxelStress::uz}};
  for (const auto& [name, member] : displacements)
    def_component(result, name, member, "Displacement of every voxel, m; float32, (depth, height, width).");
}

void bind_pictures_of_voxels(py::module_& m) {
  m.def(
      "_voxel_quantities",
      [] {
        py::dict list;
        for (const VoxelQuantity& q : voxel_quantities())
          list[py::str(std::string(q.name))] = py::make_tuple(q.symbol, q.unit, q.is_magnitude);
        return list;
      },
      "What a picture of a sample in space may show: symbol, unit and whether it is a magnitude, by name.");
  m.def(
      "_quantities_drawn",
      [](const VoxelResult& sample) {
        std::vector<std::string> names;
        for (const VoxelQuantity* q : quantities_drawn(sample)) names.emplace_back(q->name);
        return names;
      },
      py::arg("sample"), "Names of what pictures of a loaded sample show, the stress of its load first.");
  m.def("_voxel_values", &voxel_values, py::arg("sample"), py::arg("name"),
        "That quantity in all voxels; float64, (depth, height, width).");
  m.def(
      "_voxel_mean",
      [](const VoxelResult& sample, const std::string& name) {
        return stress::sample_mean(sample, quantity_named(name));
      },
      py::arg("sample"), py::arg("name"), "Its mean over the sample, as the statistics of the stress take it.");
}

void bind_voxel_functions(py::module_& m) {
  def_with_keywords(
      m, "read_voxel_map", &voxel_map_in, voxel_map_keywords(),
      "A voxel map from NumPy, NRRD, MetaImage, NIfTI or a stack of pictures (docs/formats.md), or of a table of "
      "spheres, as `arenite load --dimension 3` reads it. `phases` may be {0: \"void\", 1: \"matrix\", 2: "
      "\"particle\"}.",
      py::arg("file"), py::kw_only(), py::arg("dx") = py::none(), py::arg("labels") = recipe::MapSection{}.labels,
      py::arg("phases") = "");
  def_with_keywords(
      m, "load_voxels", &loaded_voxels, load_keywords(),
      "Loads a sample in space along z by bonds or, with method=\"elements\", by elements (docs/voxels.md). With "
      "`effective_stiffness` that stiffness of the periodic sample follows; with `failure` bonds break until "
      "the sample does.",
      py::arg("map"), py::arg("loading") = recipe::word_of(recipe::Load{}.loading), py::kw_only(), threads_argument(),
      py::arg("progress") = py::none());
}

}  // namespace

void bind_voxels(py::module_& m) {
  bind_voxel_map(m);
  bind_voxel_result(m);
  bind_pictures_of_voxels(m);
  bind_voxel_functions(m);
}

}  // namespace arenite::python
