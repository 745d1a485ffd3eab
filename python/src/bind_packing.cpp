#include <pybind11/stl.h>

#include <algorithm>
#include <numbers>

#include "arrays.hpp"
#include "calls.hpp"
#include "io/sample.hpp"
#include "model/packing.hpp"
#include "module.hpp"
#include "texture/texture.hpp"

namespace arenite::python {
namespace {

Packing make(const py::object& x, const py::object& y, const py::object& radius, const py::object& material, std::vector<Material> materials,
             double width, double height, double thickness, const std::string& periodic) {
  Packing p;
  p.materials = std::move(materials);
  Grains& g = p.grains;
  g.x = to_vector<double>(x);
  const std::size_t n = g.x.size();
  g.resize(n);
  g.y = to_vector<double>(y);
  g.radius = to_vector<double>(radius);
  if (!material.is_none()) g.material = to_vector<std::int32_t>(material);
  if (g.y.size() != n || g.radius.size() != n || g.material.size() != n)
    throw InputError("x, y, radius and material must be of one length");
  for (const std::int32_t m : g.material)
    if (m < 0 || static_cast<std::size_t>(m) >= std::max<std::size_t>(p.materials.size(), 1)) throw InputError("material numbers a material that is not in `materials`");
  if (p.materials.empty()) p.materials.push_back({"grain"});
  p.domain.wall[right].position = width;
  p.domain.wall[top].position = height;
  p.domain.thickness = thickness;
  p.domain.periodic_x = periodic.find('x') != std::string::npos;
  p.domain.periodic_y = periodic.find('y') != std::string::npos;
  p.domain.wall[left].present = p.domain.wall[right].present = !p.domain.periodic_x;
  p.domain.wall[bottom].present = p.domain.wall[top].present = !p.domain.periodic_y;
  return p;
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
  c.def("__len__", &Contacts::size);
  array_property(c, "i", [](const Contacts& k) -> auto& { return k.i; }, "First grain, int32.");
  array_property(c, "j", [](const Contacts& k) -> auto& { return k.j; }, "Second grain, or a wall if negative, int32.");
  array_property(c, "nx", [](const Contacts& k) -> auto& { return k.nx; }, "Normal, x.");
  array_property(c, "ny", [](const Contacts& k) -> auto& { return k.ny; }, "Normal, y.");
  array_property(c, "fn", [](const Contacts& k) -> auto& { return k.fn; }, "Normal force, N, positive in compression.");
  array_property(c, "ft", [](const Contacts& k) -> auto& { return k.ft; }, "Tangential force, N.");
  array_property(c, "arm_i", [](const Contacts& k) -> auto& { return k.arm_i; }, "Distance of the contact point from the centre of i, m.");
  array_property(c, "arm_j", [](const Contacts& k) -> auto& { return k.arm_j; }, "Distance from the centre of j, m; 0 for a wall.");
  array_property(c, "overlap", [](const Contacts& k) -> auto& { return k.overlap; }, "Overlap h, m; NaN where it is not known.");
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
}

py::object measured(const Packing& packing, double border, const py::object& load_axis, bool curves, const std::optional<std::vector<double>>& sigma_hyd) {
  texture::Options options;
  options.border = border;
  if (sigma_hyd) options.grain_sigma_hyd = *sigma_hyd;
  if (!load_axis.is_none()) options.load_axis = load_axis.cast<double>() * std::numbers::pi / 180;
  Call call;
  return from_json(call.without_lock([&] { return texture::to_json(texture::measure(packing, options), curves); }));
}

py::dict per_grain(const Packing& packing, double border) {
  texture::Options options;
  options.border = border;
  Call call;
  auto t = call.without_lock([&] { return texture::measure(packing, options).per_grain; });
  const auto array = [](const auto& values) { return py::array_t<typename std::decay_t<decltype(values)>::value_type>(static_cast<py::ssize_t>(values.size()), values.data()); };
  py::dict d;
  d["considered"] = array(t.considered).attr("astype")("bool");
  d["rattler"] = array(t.rattler).attr("astype")("bool");
  d["contacts"] = array(t.contacts);
  d["sigma_hyd"] = array(t.sigma_hyd);
  d["sigma_norm"] = array(t.sigma_norm);
  d["psi6"] = array(t.psi6);
  return d;
}

}  // namespace

void bind_packing(py::module_& m) {
  py::class_<Material>(m, "Material", "A material of grains.")
      .def(py::init([](std::string name, double density, double stiffness, double factor) { return Material{std::move(name), density, stiffness, factor}; }), py::arg("name"),
           py::arg("density") = 0.0, py::arg("stiffness") = 0.0, py::arg("thermoelastic_factor") = 0.0)
      .def_readonly("name", &Material::name)
      .def_readonly("density", &Material::density, "kg/m^3")
      .def_readonly("stiffness", &Material::stiffness, "Contact stiffness k, N/m (T ch. 2).")
      .def_readonly("thermoelastic_factor", &Material::thermoelastic_factor, "A, K/Pa (T ch. 2).")
      .def("__repr__", [](const Material& material) { return "<arenite.Material " + material.name + ">"; });
  bind_contacts(m);
  py::class_<Packing> packing(m, "Packing", "Grains in their frame, with the contacts between them where these are known. Arrays look into the packing's own memory.");
  packing
      .def(py::init(&make), py::arg("x"), py::arg("y"), py::arg("radius"), py::arg("material") = py::none(), py::arg("materials") = std::vector<Material>{},
           py::kw_only(), py::arg("width"), py::arg("height"), py::arg("thickness") = 1.0, py::arg("periodic") = "",
           "A packing of your own: centres and radii (m), the frame from the origin to (width, height) (m), its depth (m); `periodic` is \"\", \"x\", \"y\" or \"xy\".")
      .def("__len__", [](const Packing& p) { return p.grains.size(); })
      .def_property_readonly("contacts", [](const Packing& p) -> const Contacts& { return p.contacts; }, py::return_value_policy::reference_internal)
      .def_property_readonly("materials", [](const Packing& p) { return p.materials; })
      .def_property_readonly("domain", &domain_of, "The frame: position (m), velocity (m/s) and force (N) of every wall, width, height, thickness (m).")
      .def("__repr__", [](const Packing& p) {
        return "<arenite.Packing of " + std::to_string(p.grains.size()) + " grains and " + std::to_string(p.contacts.size()) + " contacts>";
      });
  bind_grains(packing);
  m.def("measure", &measured, py::arg("packing"), py::kw_only(), py::arg("border") = 2.5, py::arg("load_axis") = py::none(), py::arg("curves") = true,
        py::arg("sigma_hyd") = py::none(),
        "Texture and stress of a packing as a dict: solid fraction, REV, coordination, fabric, forces, stress, normalised stress, local order; each statistic is "
        "{\"value\", \"error\"}. `border`: strip left out along walls, mean diameters (T 3.2.4). `load_axis`: degrees from x; found from the stress if not given. "
        "`sigma_hyd`: stress of every grain as it was measured, Pa, instead of that of its contacts.");
  m.def("measure_grains", &per_grain, py::arg("packing"), py::kw_only(), py::arg("border") = 2.5,
        "What texture knows of every grain, as arrays: considered, rattler, contacts, sigma_hyd (Pa, tension positive), sigma_norm, psi6.");
  m.def("read_packing",
        [](const std::string& grains, const std::string& contacts, const std::string& format) {
          io::SampleOptions options;
          options.format = format;
          return io::read_sample(grains, contacts, options).packing;
        },
        py::arg("grains"), py::arg("contacts") = "", py::arg("format") = "auto",
        "Grains and contacts from files of YADE, LAMMPS, MercuryDPM or CSV, as `arenite measure` reads them.");
}

}  // namespace arenite::python
