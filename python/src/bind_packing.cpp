#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <numbers>

#include "arrays.hpp"
#include "calls.hpp"
#include "file_notes.hpp"
#include "model/shapes.hpp"
#include "module.hpp"
#include "own_packing.hpp"

namespace arenite::python {
namespace {

Packing make(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius, const std::optional<ArrayLike>& material,
             std::vector<Material> materials, const Quantity& width, const Quantity& height, const Quantity& thickness,
             const std::string& periodic, const py::object& contacts, const std::pair<Quantity, Quantity>& origin) {
  const OwnContainer container{
      {origin.first.si(dimension::length, "origin"), origin.second.si(dimension::length, "origin")},
      width.si(dimension::length, "width"),
      height.si(dimension::length, "height"),
      thickness.si(dimension::length, "thickness"),
      periodic};
  return own_packing(x, y, radius, material, std::move(materials), container, contacts);
}

Material material(std::string name, const Quantity& density, const Quantity& stiffness, const Quantity& factor) {
  return {std::move(name), density.si(dimension::density, "density"), stiffness.si(dimension::stiffness, "stiffness"),
          factor.si(dimension::thermoelastic_factor, "thermoelastic_factor")};
}

py::list boundaries_of(const Domain& domain) {
  py::list all;
  for (const Boundary& boundary : domain.boundaries) {
    py::dict d;
    d["name"] = boundary.name;
    d["points"] = rows_of_points<2>(boundary.points);
    d["closed"] = boundary.closed;
    d["present"] = boundary.present;
    all.append(d);
  }
  return all;
}

py::dict domain_of(const Packing& p) {
  py::dict d;
  const Domain& box = p.domain;
  for (int side = 0; side < 4; ++side) {
    const Wall& wall = box.wall[static_cast<std::size_t>(side)];
    py::dict w;
    w["present"] = wall.present;
    w["position"] = wall.position;
    w["velocity"] = wall.velocity;
    w["force"] = wall.force;
    w["shear_force"] = wall.shear_force;
    d[side_names[static_cast<std::size_t>(side)]] = w;
  }
  d["width"] = box.width();
  d["height"] = box.height();
  d["thickness"] = box.thickness;
  d["periodic_x"] = box.periodic[0];
  d["periodic_y"] = box.periodic[1];
  d["tilt"] = box.tilt;
  d["boundaries"] = boundaries_of(box);
  return d;
}

/// Bonds as arrays of equal length, by name.
py::dict bonds_of(const Packing& packing) {
  const auto& bonds = packing.bonds;
  const auto column = [&](auto get) {
    std::vector<std::decay_t<decltype(get(bonds.front()))>> values;
    for (const Bond& bond : bonds) values.push_back(get(bond));
    return taken_over(std::move(values));
  };
  py::dict d;
  d["i"] = column([](const Bond& b) { return b.i; });
  d["j"] = column([](const Bond& b) { return b.j; });
  d["broken"] = column([](const Bond& b) { return static_cast<std::int32_t>(b.broken); });
  d["time"] = column([](const Bond& b) { return b.time; });
  d["x"] = column([](const Bond& b) { return b.place.x; });
  d["y"] = column([](const Bond& b) { return b.place.y; });
  d["fn"] = column([](const Bond& b) { return b.fn; });
  d["ft"] = column([](const Bond& b) { return b.ft; });
  d["moment"] = column([](const Bond& b) { return b.moment; });
  d["energy"] = column([](const Bond& b) { return b.energy; });
  d["load"] = column([](const Bond& b) { return b.load; });
  d["length"] = column([](const Bond& b) { return b.length; });
  return d;
}

/// Cohesive pairs as arrays of equal length, by name.
py::dict cohesive_of(const Packing& packing) {
  const auto column = [&](auto member) {
    std::vector<std::decay_t<decltype(CohesivePair{}.*member)>> values;
    for (const CohesivePair& pair : packing.cohesive) values.push_back(pair.*member);
    return taken_over(std::move(values));
  };
  py::dict d;
  d["i"] = column(&CohesivePair::i);
  d["j"] = column(&CohesivePair::j);
  d["gap"] = column(&CohesivePair::gap);
  d["pull"] = column(&CohesivePair::pull);
  d["energy"] = column(&CohesivePair::energy);
  return d;
}

py::array_t<double> levers_of(const Contacts& contacts) {
  std::vector<Vec2> points;
  for (std::size_t c = 0; c < contacts.size(); ++c) points.push_back(contacts.lever_i(c));
  return rows_of_points<2>(points);
}

/// One array a grain; of disks, too.
py::list outlines_of(const Packing& packing) {
  py::list all;
  for (std::size_t g = 0; g < packing.grains.size(); ++g)
    all.append(rows_of_points<2>(outline_of(packing.grains, g, 0.1)));
  return all;
}

void bind_contacts(py::module_& m) {
  py::class_<Contacts> c(m, "Contacts",
                         "Contacts, each once: arrays of equal length. n points from grain j to grain i, t is n "
                         "rotated by +90 degrees, and the force on i is fn n + ft t, fn > 0 repulsive. j = -1, -2, -3, "
                         "-4 stands for the left, right, bottom, top wall.");
  c.def("__len__", &Contacts::size, "Number of contacts.");
  array_property(
      c, "i", [](const Contacts& k) -> auto& { return k.i; },
      "First grain, its index in the packing's arrays (not its id), int32.");
  array_property(
      c, "j", [](const Contacts& k) -> auto& { return k.j; },
      "Second grain, its index in the packing's arrays, or a wall if negative, int32.");
  coordinate_property(
      c, "nx", [](const Contacts& k) -> auto& { return k.normal; }, &Vec2::x, "Normal, x.");
  coordinate_property(
      c, "ny", [](const Contacts& k) -> auto& { return k.normal; }, &Vec2::y, "Normal, y.");
  array_property(
      c, "fn", [](const Contacts& k) -> auto& { return k.fn; }, "Normal force, N, positive in compression.");
  array_property(
      c, "ft", [](const Contacts& k) -> auto& { return k.ft; }, "Tangential force, N.");
  array_property(
      c, "arm_i", [](const Contacts& k) -> auto& { return k.arm_i; },
      "Distance of the contact point from the centre of i, m.");
  array_property(
      c, "arm_j", [](const Contacts& k) -> auto& { return k.arm_j; },
      "Distance from the centre of j, m; 0 for a wall.");
  array_property(
      c, "overlap", [](const Contacts& k) -> auto& { return k.overlap; }, "Overlap h, m; NaN if not known.");
  array_property(
      c, "sliding_velocity", [](const Contacts& k) -> auto& { return k.sliding_velocity; },
      "Tangential velocity at the contact point, m/s; NaN if not known.");
  array_property(
      c, "glued", [](const Contacts& k) -> auto& { return k.glued; }, "1 where adhesion acts.");
  c.def_property_readonly(
      "points", [](const Contacts& k) { return levers_of(k); },
      "Contact points from the centre of grain i, m, n x 2; not on the normal through the centre if grains are not "
      "disks.");
}

void bind_grains(py::class_<Packing>& c) {
  array_property(
      c, "id", [](const Packing& p) -> auto& { return p.grains.id; }, "The user's name of every grain, int64.");
  coordinate_property(
      c, "x", [](const Packing& p) -> auto& { return p.grains.position; }, &Vec2::x, "Centres, m.");
  coordinate_property(
      c, "y", [](const Packing& p) -> auto& { return p.grains.position; }, &Vec2::y, "Centres, m.");
  array_property(
      c, "radius", [](const Packing& p) -> auto& { return p.grains.radius; },
      "Radii, m; for grains that are not disks, those of the disks of equal area.");
  array_property(
      c, "material", [](const Packing& p) -> auto& { return p.grains.material; },
      "Index in `materials` of every grain, int32.");
  array_property(
      c, "zone", [](const Packing& p) -> auto& { return p.grains.zone; },
      "0, or the number of a region: 1 is the glued agglomerate.");
  array_property(
      c, "angle", [](const Packing& p) -> auto& { return p.grains.angle; },
      "Rotations since the start, rad, counter-clockwise.");
  coordinate_property(
      c, "vx", [](const Packing& p) -> auto& { return p.grains.velocity; }, &Vec2::x, "Velocities, m/s.");
  coordinate_property(
      c, "vy", [](const Packing& p) -> auto& { return p.grains.velocity; }, &Vec2::y, "Velocities, m/s.");
  array_property(
      c, "omega", [](const Packing& p) -> auto& { return p.grains.omega; },
      "Angular velocities, rad/s, counter-clockwise.");
}

}  // namespace

void bind_packing(py::module_& m) {
  py::class_<Material>(m, "Material", "A material of grains.")
      .def(py::init(&material), py::arg("name"), py::arg("density") = 0.0, py::arg("stiffness") = 0.0,
           py::arg("thermoelastic_factor") = 0.0,
           "Density (kg/m^3), contact stiffness k (N/m) and thermoelastic factor A (K/Pa), or text with a unit; 0: not "
           "known.")
      .def_readonly("name", &Material::name, "Name in recipes, tables and figures.")
      .def_readonly("density", &Material::density, "kg/m^3")
      .def_readonly("stiffness", &Material::stiffness, "Contact stiffness k, N/m (T ch. 2).")
      .def_readonly("thermoelastic_factor", &Material::thermoelastic_factor, "A, K/Pa (T ch. 2).")
      .def_readonly("youngs_modulus", &Material::youngs_modulus,
                    "Young's modulus E, Pa; None if not given in the recipe.")
      .def_readonly("poisson", &Material::poisson, "Poisson's ratio nu; None if not given in the recipe.")
      .def("__repr__", [](const Material& of) { return "<arenite.Material " + of.name + ">"; });
  bind_contacts(m);
  py::class_<Packing> packing(
      m, "Packing", py::dynamic_attr(),
      "Grains in their container, with the contacts between them if known. Arrays refer to the packing's own memory.");
  packing
      .def(py::init(&make), py::arg("x"), py::arg("y"), py::arg("radius"), py::arg("material") = py::none(),
           py::arg("materials") = std::vector<Material>{}, py::kw_only(), py::arg("width"), py::arg("height"),
           py::arg("thickness") = 1.0, py::arg("periodic") = "", py::arg("contacts") = py::none(),
           py::arg("origin") = std::pair(0.0, 0.0),
           "A packing from your own data: centres and radii (m), width and height of the container, its depth (m, or "
           "text with a unit; 0: not known) and lower left corner `origin`; `periodic` is \"\", \"x\", \"y\" or "
           "\"xy\". `contacts`: a dict, a table of pandas or Contacts with i and j (grains from 0; j = -1, -2, -3, -4: "
           "left, right, bottom, top wall) and, where known, fn and ft (N) and the normal nx, ny from j to i, which "
           "follows from the centres otherwise.")
      .def(
          "__len__", [](const Packing& p) { return p.grains.size(); }, "Number of grains.")
      .def_property_readonly(
          "contacts", [](const Packing& p) -> const Contacts& { return p.contacts; },
          py::return_value_policy::reference_internal, "Known contacts, including those with walls.")
      .def_property_readonly("bonds", &bonds_of,
                             "Bonds by name, arrays of equal length: grains i < j (indices into the arrays), broken (0 "
                             "intact, 1 in tension, 2 in bending, 3 in shear), time (s) and position x, y (m) of the "
                             "break, current fn, ft (N, signs as for contacts) and moment on i (N m), energy (J, at "
                             "the break), load (stress over strength), length (m, initial).")
      .def_property_readonly("cohesive", &cohesive_of,
                             "Pairs joined by adhesion or a liquid bridge, by name, arrays of equal length: grains i < "
                             "j (indices into the arrays), gap (m, negative if they overlap), pull (attraction, N; for "
                             "touching grains part of the contact's fn), energy (J, 0 at the onset of the attraction).")
      .def_property_readonly(
          "materials", [](const Packing& p) { return p.materials; }, "Materials, to which `material` refers by index.")
      .def_property_readonly(
          "domain", &domain_of,
          "The container: position (m), velocity (m/s) and force (N) of every wall, width, height, thickness (m), and "
          "boundaries and membranes (points, m).")
      .def_property_readonly("notes", &notes_kept,
                             "What read_packing told of the files: a list of sentences; empty for other packings.")
      .def_property_readonly(
          "are_disks", [](const Packing& p) { return p.grains.shapes.empty(); }, "Whether all grains are disks.")
      .def("outlines", &outlines_of,
           "Points along the outline of every grain at its position, m: a list of arrays n x 2, counter-clockwise, not "
           "closed.")
      .def_property_readonly(
          "gyration",
          [](const Packing& p) {
            const Grains& g = p.grains;
            py::array_t<double> radii(static_cast<py::ssize_t>(g.size()));
            for (std::size_t k = 0; k < g.size(); ++k)
              radii.mutable_at(static_cast<py::ssize_t>(k)) =
                  g.shapes.empty() ? g.radius[k] / std::numbers::sqrt2 : g.shapes.gyration[k];
            return radii;
          },
          "Radius of gyration of every grain about its centre of mass, m.")
      .def("__repr__", [](const Packing& p) {
        return fmt::format("<arenite.Packing of {} grains and {} contacts>", p.grains.size(), p.contacts.size());
      });
  bind_grains(packing);
}

}  // namespace arenite::python
