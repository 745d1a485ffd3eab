#include <pybind11/stl.h>

#include <cstdint>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "columns.hpp"
#include "core/problems.hpp"
#include "file_notes.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "model/result.hpp"
#include "module.hpp"

namespace arenite::python {
namespace {

/// Vectors as rows of an array that shares their memory.
py::array_t<double> rows_view(const std::vector<Vec3>& values, const py::object& owner) {
  py::array_t<double> array({static_cast<py::ssize_t>(values.size()), py::ssize_t{3}},
                            reinterpret_cast<const double*>(values.data()), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class Class> void def_rows(Class& c, const char* name, auto of, const char* sentence) {
  c.def_property_readonly(
      name, [of](const py::object& self) { return rows_view(of(self.cast<const PackingIn<3>&>()), self); }, sentence);
}

template <class Class> void def_array(Class& c, const char* name, auto of, const char* sentence) {
  c.def_property_readonly(
      name, [of](const py::object& self) { return view(of(self.cast<const PackingIn<3>&>()), self); }, sentence);
}

/// Faces are so many of the points, one after the other.
py::list boundaries_in_space(const DomainIn<3>& domain) {
  py::list all;
  for (const BoundaryIn<3>& boundary : domain.boundaries) {
    py::dict d;
    d["name"] = boundary.name;
    d["points"] = rows_of_points<3>(boundary.points);
    d["corners"] = taken_over(boundary.corners);
    d["present"] = boundary.present;
    all.append(d);
  }
  return all;
}

py::dict domain_in_space(const PackingIn<3>& packing) {
  py::dict d;
  const Container<3>& box = packing.domain;
  for (std::size_t side = 0; side < box.wall.size(); ++side) {
    const WallIn<3>& wall = box.wall[side];
    py::dict w;
    w["present"] = wall.present;
    w["position"] = wall.position;
    w["velocity"] = wall.velocity;
    w["force"] = wall.force;
    w["shear_force"] = py::make_tuple(wall.shear_force.x, wall.shear_force.y, wall.shear_force.z);
    d[any_side_names[side]] = w;
  }
  d["size"] = py::make_tuple(box.extent(0), box.extent(1), box.extent(2));
  d["periodic"] = py::make_tuple(box.periodic[0], box.periodic[1], box.periodic[2]);
  d["tilt"] = box.tilt;
  d["boundaries"] = boundaries_in_space(packing.domain);
  return d;
}

/// Bonds as arrays of equal length, by name.
py::dict bonds_in_space(const PackingIn<3>& packing) {
  using B = BondIn<3>;
  const auto& bonds = packing.bonds;
  const auto column = [&](auto member) {
    std::vector<std::decay_t<decltype(B{}.*member)>> values;
    for (const B& bond : bonds) values.push_back(bond.*member);
    return taken_over(std::move(values));
  };
  const auto rows = [&](auto of) {
    py::array_t<double> all({static_cast<py::ssize_t>(bonds.size()), py::ssize_t{3}});
    auto at = all.mutable_unchecked<2>();
    for (std::size_t n = 0; n < bonds.size(); ++n)
      for (int axis = 0; axis < 3; ++axis) at(static_cast<py::ssize_t>(n), axis) = of(bonds[n])[axis];
    return all;
  };
  std::vector<std::int32_t> broken;
  for (const B& bond : bonds) broken.push_back(static_cast<std::int32_t>(bond.broken));
  py::dict d;
  d["i"] = column(&B::i);
  d["j"] = column(&B::j);
  d["broken"] = taken_over(std::move(broken));
  d["time"] = column(&B::time);
  d["place"] = rows([](const B& b) { return b.place; });
  d["force"] = rows([&](const B& b) { return b.fn == 0 ? Vec3{} : force_on_i(packing, b); });
  d["moment"] = rows([](const B& b) { return b.moment; });
  d["energy"] = column(&B::energy);
  d["load"] = column(&B::load);
  d["length"] = column(&B::length);
  return d;
}

void bind_sphere_packing(py::module_& m) {
  py::class_<PackingIn<3>> packing(m, "SpherePacking", py::dynamic_attr(),
                                   "Spheres in their container, with their contacts; SI units.");
  def_rows(
      packing, "position", [](const auto& p) -> auto& { return p.grains.position; }, "Centres, m; (N, 3).");
  def_rows(
      packing, "velocity", [](const auto& p) -> auto& { return p.grains.velocity; }, "m/s; (N, 3).");
  def_rows(
      packing, "omega", [](const auto& p) -> auto& { return p.grains.omega; }, "Angular velocity, rad/s; (N, 3).");
  def_array(
      packing, "radius", [](const auto& p) -> auto& { return p.grains.radius; }, "m; (N,).");
  def_array(
      packing, "id", [](const auto& p) -> auto& { return p.grains.id; }, "Names of the spheres; (N,).");
  def_array(
      packing, "material", [](const auto& p) -> auto& { return p.grains.material; },
      "Number of the material, from 0; (N,).");
  def_array(
      packing, "contact_i", [](const auto& p) -> auto& { return p.contacts.i; },
      "Of each contact the sphere on which its force acts, from 0; (M,).");
  def_array(
      packing, "contact_j", [](const auto& p) -> auto& { return p.contacts.j; },
      "Its partner; -1 to -6: the left, right, bottom, top, back, front wall; (M,).");
  packing.def_property_readonly(
      "materials", [](const PackingIn<3>& p) { return p.materials; },
      "Materials, to which `material` refers by index.");
  def_rows(
      packing, "normal", [](const auto& p) -> auto& { return p.contacts.normal; }, "Unit vector from j to i; (M, 3).");
  def_array(
      packing, "fn", [](const auto& p) -> auto& { return p.contacts.fn; },
      "Normal force, N, positive: repulsive; (M,).");
  def_array(
      packing, "overlap", [](const auto& p) -> auto& { return p.contacts.overlap; }, "m; (M,).");
  packing
      .def_property_readonly("notes", &notes_kept,
                             "What read_packing told of the files: a list of sentences; empty for other packings.")
      .def_property_readonly(
          "force",
          [](const PackingIn<3>& p) {
            py::array_t<double> force({static_cast<py::ssize_t>(p.contacts.size()), py::ssize_t{3}});
            auto at = force.mutable_unchecked<2>();
            for (std::size_t c = 0; c < p.contacts.size(); ++c)
              for (int axis = 0; axis < 3; ++axis)
                at(static_cast<py::ssize_t>(c), axis) = p.contacts.force_on_i(c)[axis];
            return force;
          },
          "Force of each contact on sphere i, N; (M, 3).")
      .def_property_readonly("bonds", &bonds_in_space,
                             "Bonds as arrays by name: i, j, broken (0: whole; 1 tension, 2 bending, 3 shear, 4 "
                             "twisting), time and place of the break, force and moment on i, energy, load, length.")
      .def_property_readonly("domain", &domain_in_space,
                             "The container: its six sides, size and periodic directions, and the boundaries in it: "
                             "points (N, 3), and how many of them are the corners of each face.")
      .def(
          "measure",
          [](const PackingIn<3>& p, double border) {
            Measuring how;
            if (!(border >= 0 && border <= 1000))
              throw refusal("a border of {:g} mean diameters is not possible; give 0 to 1000", border);
            how.border = border;
            return to_python(texture::measure_spheres(p, texture::sphere_options(p, how)));
          },
          py::arg("border") = Measuring{}.border,
          "Solid fraction, coordination, fabric, stress and forces, each with its error; `border`: width of the strip "
          "left out along walls, in mean diameters. Rattlers are judged by whether contacts have friction.")
      .def(
          "__len__", [](const PackingIn<3>& p) { return p.grains.size(); }, "Number of spheres.")
      .def("__repr__", [](const PackingIn<3>& p) {
        return "<arenite.SpherePacking of " + std::to_string(p.grains.size()) + " spheres>";
      });
}

void bind_sphere_stages(py::module_& m) {
  py::class_<SnapshotIn<3>>(m, "SphereSnapshot", "One stored state of a stage of spheres.")
      .def_readonly("time", &SnapshotIn<3>::time, "s since the start of the run.")
      .def_readonly("step", &SnapshotIn<3>::step, "Time steps since the start of the run.")
      .def_readonly("label", &SnapshotIn<3>::label, "\"increment 3 of 10\", \"cycle 2 maximum\".")
      .def_property_readonly(
          "packing", [](const SnapshotIn<3>& f) -> const PackingIn<3>& { return f.packing; },
          py::return_value_policy::reference_internal, "Spheres and contacts in this state.")
      .def("__repr__", [](const SnapshotIn<3>& f) { return "<arenite.SphereSnapshot \"" + f.label + "\">"; });
  py::class_<SphereResult>(m, "SphereStage", "Result of one stage of spheres.")
      .def_readonly("name", &SphereResult::name, "Its name in the recipe.")
      .def_readonly("converged", &SphereResult::converged, "Whether equilibrium was reached.")
      .def_readonly("outcome", &SphereResult::outcome, "How it ended, in words.")
      .def_property_readonly(
          "provenance", [](const SphereResult& s) { return to_python(s.provenance); },
          "Provenance: version, stage, input_hash, recipe, seed, kernel, options.")
      .def_property_readonly(
          "snapshots",
          [](const py::object& self) {
            py::list snapshots;
            for (const auto& snapshot : self.cast<const SphereResult&>().snapshots)
              snapshots.append(py::cast(&snapshot, py::return_value_policy::reference_internal, self));
            return snapshots;
          },
          "Stored states in time order.")
      .def_property_readonly(
          "asked",
          [](const SphereResult& stage) {
            py::dict d;
            if (stage.asked.known) d["friction"] = stage.asked.friction;
            return d;
          },
          "What it was asked for: the friction between spheres, where it is known.")
      .def_property_readonly(
          "states",
          [](const SphereResult& stage) {
            std::vector<PackingIn<3>> states;
            for (const auto& snapshot : stage.snapshots) states.push_back(snapshot.packing);
            return states;
          },
          "Its stored states (copied), the last one handed on.")
      .def_property_readonly(
          "time",
          [](const SphereResult& stage) {
            std::vector<double> times;
            for (const auto& snapshot : stage.snapshots) times.push_back(snapshot.time);
            return taken_over(std::move(times));
          },
          "Times of these states since the start of the run, s.")
      .def_property_readonly(
          "history", [](const py::object& self) { return columns_of(self.cast<const SphereResult&>().history, self); },
          "Columns of its history by name, in SI units.")
      .def_property_readonly(
          "numbers", [](const SphereResult& stage) { return to_python(stage.texture); },
          "What was measured of the last state, as `arenite show --json` prints it.");
}

}  // namespace

void bind_spheres(py::module_& m) {
  bind_sphere_packing(m);
  bind_sphere_stages(m);
}

}  // namespace arenite::python
