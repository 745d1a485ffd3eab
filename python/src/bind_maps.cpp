#include "arrays.hpp"
#include "model/grain_swing.hpp"
#include "model/lockin_maps.hpp"
#include "model/picture_grains.hpp"
#include "module.hpp"
#include "thermal/thermography/grain_motion.hpp"

namespace arenite::python {
namespace {

void bind_lockin_maps(py::module_& m) {
  py::class_<LockinMaps> c(m, "LockinMaps", "What a lock-in finds in every pixel, in the film's unit; arrays are (height, width), the top row first.");
  c.def_readonly("frequency", &LockinMaps::frequency, "Hz, refined on the film.")
      .def_readonly("frequency_error", &LockinMaps::frequency_error, "Hz.")
      .def_readonly("reference_phase", &LockinMaps::reference_phase, "rad.")
      .def_readonly("frames", &LockinMaps::frames, "Number of frames that were used.")
      .def_property_readonly("full_swing", [](const LockinMaps& l) { return l.convention == SwingConvention::full; }, "Amplitudes are full swings, not half ones.");
  const auto map = [&c](const char* name, std::vector<float> LockinMaps::* member, const char* doc) {
    c.def_property_readonly(name, [member](const py::object& self) {
      const auto& maps = self.cast<const LockinMaps&>();
      return image_view(maps.*member, maps.height, maps.width, self);
    }, doc);
  };
  map("mean", &LockinMaps::mean, "Level at the middle of the film.");
  map("drift", &LockinMaps::drift, "Slope of the mean, unit/s.");
  map("amplitude", &LockinMaps::amplitude, "Of the swing at the load frequency.");
  map("phase", &LockinMaps::phase, "rad.");
  map("in_phase", &LockinMaps::in_phase, "Signed swing: positive where a pixel warms when the load rises.");
  map("quadrature", &LockinMaps::quadrature, "Swing a quarter of a cycle off.");
  map("standard_error", &LockinMaps::standard_error, "Of `in_phase`.");
  map("noise_floor", &LockinMaps::noise_floor, "Amplitude that noise alone shows on the mean.");
  map("second_harmonic", &LockinMaps::second_harmonic, "Amplitude at twice the frequency: slip, plasticity.");
  map("residual", &LockinMaps::residual, "Root mean square of what the fit leaves.");
}

void bind_grains(py::module_& m) {
  py::class_<PictureGrains> g(m, "PictureGrains", "Grains found in a picture, in pixels; the pixel in column c and row r has its centre at (c, r).");
  g.def("__len__", &PictureGrains::size, "Number of grains.");
  array_property(g, "x", [](const PictureGrains& p) -> auto& { return p.x; }, "Centres, pixels.");
  array_property(g, "y", [](const PictureGrains& p) -> auto& { return p.y; }, "Centres, pixels, downwards.");
  array_property(g, "radius", [](const PictureGrains& p) -> auto& { return p.radius; }, "Pixels.");
  array_property(g, "position_error", [](const PictureGrains& p) -> auto& { return p.position_error; }, "Standard error of the centre along one axis, pixels.");
  array_property(g, "radius_error", [](const PictureGrains& p) -> auto& { return p.radius_error; }, "Pixels.");
  array_property(g, "brightness", [](const PictureGrains& p) -> auto& { return p.brightness; }, "Mean over the inner half of the disk.");
  array_property(g, "score", [](const PictureGrains& p) -> auto& { return p.score; }, "Share of the rim that shows an edge.");
  array_property(g, "material", [](const PictureGrains& p) -> auto& { return p.material; }, "Class by brightness, darkest first; -1 unknown.");
  array_property(g, "size_class", [](const PictureGrains& p) -> auto& { return p.size_class; }, "Class by radius, smallest first.");
}

void bind_motion(py::module_& m) {
  py::class_<GrainMotion> c(m, "GrainMotion", "Motion of every grain at the load frequency f, pixels, y down: x(t) = x + cos_x cos(2 pi f t) + sin_x sin(2 pi f t), t in s after the "
                                              "first frame.");
  c.def("__len__", &GrainMotion::size, "Number of grains.");
  array_property(c, "cos_x", [](const GrainMotion& p) -> auto& { return p.cos_x; }, "Pixels.");
  array_property(c, "sin_x", [](const GrainMotion& p) -> auto& { return p.sin_x; }, "Pixels.");
  array_property(c, "cos_y", [](const GrainMotion& p) -> auto& { return p.cos_y; }, "Pixels.");
  array_property(c, "sin_y", [](const GrainMotion& p) -> auto& { return p.sin_y; }, "Pixels.");
  array_property(c, "error", [](const GrainMotion& p) -> auto& { return p.error; }, "Standard error of each of the four, pixels; infinite for a grain that shows no contrast.");
  c.def_property_readonly("lost", [](const GrainMotion& motion) { return taken_over_as_bool(thermography::lost_grains(motion)); },
                          "True for grains that the film does not show well enough to follow.");
}

}  // namespace

void bind_maps(py::module_& m) {
  bind_lockin_maps(m);
  bind_grains(m);
  bind_motion(m);
}

}  // namespace arenite::python
