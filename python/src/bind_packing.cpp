#include <pybind11/stl.h>

#include <fmt/format.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/error.hpp"
#include "model/packing.hpp"
#include "module.hpp"
#include "own_packing.hpp"

namespace arenite::python {
namespace {

Packing make(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius, const std::optional<ArrayLike>& material, std::vector<Material> materials,
             const Quantity& width, const Quantity& height, const Quantity& thickness, const std::string& periodic, const py::object& contacts,
             const std::pair<Quantity, Quantity>& origin) {
  const OwnFrame frame{{origin.first.si(dimension::length, "origin"), origin.second.si(dimension::length, "origin")},
                       width.si(dimension::length, "width"), height.si(dimension::length, "height"), thickness.si(dimension::length, "thickness"), periodic};
  return own_packing(x, y, radius, material, std::move(materials), frame, contacts);
}

Material material(std::string name, const Quantity& density, const Quantity& stiffness, const Quantity& factor) {
  return {std::move(name), density.si(dimension::density, "density"), stiffness.si(dimension::stiffness, "stiffness"),
          factor.si(dimension::thermoelastic_factor, "thermoelastic_factor")};
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
  d["periodic_x"] = box.periodic_x;
  d["periodic_y"] = box.periodic_y;
  d["tilt"] = box.tilt;
  return d;
}

void bind_contacts(py::module_& m) {
  py::class_<Contacts> c(m, "Contacts", "Contacts, each once: arrays of one length. n points from grain j to grain i, t is n turned by +90 degrees, and the "
                                        "force on i is fn n + ft t, fn > 0 pushing apart. j = -1, -2, -3, -4 stands for the left, right, bottom, top wall.");
  c.def("__len__", &Contacts::size, "Number of contacts.");
  array_property(c, "i", [](const Contacts& k) -> auto& { return k.i; }, "First grain, its place in the packing's arrays (not its id), int32.");
  array_property(c, "j", [](const Contacts& k) -> auto& { return k.j; }, "Second grain, its place in the packing's arrays, or a wall if negative, int32.");
  array_property(c, "nx", [](const Contacts& k) -> auto& { return k.nx; }, "Normal, x.");
  array_property(c, "ny", [](const Contacts& k) -> auto& { return k.ny; }, "Normal, y.");
  array_property(c, "fn", [](const Contacts& k) -> auto& { return k.fn; }, "Normal force, N, positive in compression.");
  array_property(c, "ft", [](const Contacts& k) -> auto& { return k.ft; }, "Tangential force, N.");
  array_property(c, "arm_i", [](const Contacts& k) -> auto& { return k.arm_i; }, "Distance of the contact point from the centre of i, m.");
  array_property(c, "arm_j", [](const Contacts& k) -> auto& { return k.arm_j; }, "Distance from the centre of j, m; 0 for a wall.");
  array_property(c, "overlap", [](const Contacts& k) -> auto& { return k.overlap; }, "Overlap h, m; NaN where it is not known.");
  array_property(c, "sliding_velocity", [](const Contacts& k) -> auto& { return k.sliding_velocity; }, "Tangential velocity at the contact point, m/s; NaN where it is not known.");
  array_property(c, "glued", [](const Contacts& k) -> auto& { return k.glued; }, "1 where adhesion acts.");
}

void bind_grains(py::class_<Packing>& c) {
  array_property(c, "id", [](const Packing& p) -> auto& { return p.grains.id; }, "The user's name of every grain, int64.");
  array_property(c, "x", [](const Packing& p) -> auto& { return p.grains.x; }, "Centres, m.");
  array_property(c, "y", [](const Packing& p) -> auto& { return p.grains.y; }, "Centres, m.");
  array_property(c, "radius", [](const Packing& p) -> auto& { return p.grains.radius; }, "Radii, m.");
  array_property(c, "material", [](const Packing& p) -> auto& { return p.grains.material; }, "Place in `materials` of every grain, int32.");
  array_property(c, "zone", [](const Packing& p) -> auto& { return p.grains.zone; }, "0, or the number of a region: 1 is the glued agglomerate.");
  array_property(c, "angle", [](const Packing& p) -> auto& { return p.grains.angle; }, "Rotations since the start, rad, counter-clockwise.");
  array_property(c, "vx", [](const Packing& p) -> auto& { return p.grains.vx; }, "Velocities, m/s.");
  array_property(c, "vy", [](const Packing& p) -> auto& { return p.grains.vy; }, "Velocities, m/s.");
  array_property(c, "omega", [](const Packing& p) -> auto& { return p.grains.omega; }, "Angular velocities, rad/s, counter-clockwise.");
}

}  // namespace

void bind_packing(py::module_& m) {
  py::class_<Material>(m, "Material", "A material of grains.")
      .def(py::init(&material), py::arg("name"), py::arg("density") = 0.0, py::arg("stiffness") = 0.0, py::arg("thermoelastic_factor") = 0.0,
           "Density (kg/m^3), contact stiffness k (N/m) and thermoelastic factor A (K/Pa), or text with a unit; 0: not known.")
      .def_readonly("name", &Material::name, "As recipes, tables and figures call it.")
      .def_readonly("density", &Material::density, "kg/m^3")
      .def_readonly("stiffness", &Material::stiffness, "Contact stiffness k, N/m (T ch. 2).")
      .def_readonly("thermoelastic_factor", &Material::thermoelastic_factor, "A, K/Pa (T ch. 2).")
      .def("__repr__", [](const Material& of) { return "<arenite.Material " + of.name + ">"; });
  bind_contacts(m);
  py::class_<Packing> packing(m, "Packing", "Grains in their frame, with the contacts between them where these are known. Arrays look into the packing's own memory.");
  packing
      .def(py::init(&make), py::arg("x"), py::arg("y"), py::arg("radius"), py::arg("material") = py::none(), py::arg("materials") = std::vector<Material>{},
           py::kw_only(), py::arg("width"), py::arg("height"), py::arg("thickness") = 1.0, py::arg("periodic") = "", py::arg("contacts") = py::none(),
           py::arg("origin") = std::pair(0.0, 0.0),
           "A packing of your own: centres and radii (m), width and height of the frame, its depth (m, or text with a unit; 0: not known) and lower left corner `origin`; `periodic` is "
           "\"\", \"x\", \"y\" or \"xy\". `contacts`: a dict, a table of pandas or Contacts with i and j (grains from 0; j = -1, -2, -3, -4: left, right, bottom, top "
           "wall) and, where known, fn and ft (N) and the normal nx, ny from j to i, which follows from the centres otherwise.")
      .def("__len__", [](const Packing& p) { return p.grains.size(); }, "Number of grains.")
      .def_property_readonly("contacts", [](const Packing& p) -> const Contacts& { return p.contacts; }, py::return_value_policy::reference_internal,
                             "Those that are known, with walls too.")
      .def_property_readonly("materials", [](const Packing& p) { return p.materials; }, "Those that `material` numbers.")
      .def_property_readonly("domain", &domain_of, "The frame: position (m), velocity (m/s) and force (N) of every wall, width, height, thickness (m).")
      .def("__repr__", [](const Packing& p) { return fmt::format("<arenite.Packing of {} grains and {} contacts>", p.grains.size(), p.contacts.size()); });
  bind_grains(packing);
}

}  // namespace arenite::python
