#include <pybind11/stl.h>

#include "arrays.hpp"
#include "module.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"
#include "thermal/thermography/lockin.hpp"

/// The maps and grains that the steps from a film to grain stresses give.
namespace arenite::python {
namespace {

void bind_lockin_maps(py::module_& m) {
  py::class_<LockinMaps> c(
      m, "LockinMaps",
      "Result of a lock-in for every pixel, in the film's unit; arrays are (height, width), the top row first.");
  c.def_readonly("frequency", &LockinMaps::frequency, "Hz, refined on the film.")
      .def_readonly("frequency_error", &LockinMaps::frequency_error, "Hz.")
      .def_readonly("reference_phase", &LockinMaps::reference_phase, "rad.")
      .def_readonly("frames", &LockinMaps::frames, "Number of frames used.")
      .def_property_readonly(
          "disturbances", [](const LockinMaps& l) { return l.disturbances; },
          "What the film shows beside the load and its drift, each a sentence.")
      .def_property_readonly(
          "blank_frames", [](const LockinMaps& l) { return l.blank; },
          "Frames that hold no whole picture (no numbers in more than a tenth of their pixels, one number everywhere, "
          "or the frame before once more) and were left out.")
      .def_property_readonly(
          "peak_to_peak", [](const LockinMaps& l) { return l.convention == AmplitudeConvention::peak_to_peak; },
          "Amplitudes are peak to peak.");
  const auto map = [&c](const char* name, std::vector<float> LockinMaps::*member, const char* doc) {
    c.def_property_readonly(
        name,
        [member](const py::object& self) {
          const auto& maps = self.cast<const LockinMaps&>();
          return image_view(maps.*member, maps.height, maps.width, self);
        },
        doc);
  };
  map("mean", &LockinMaps::mean, "Level at the middle of the film.");
  map("drift", &LockinMaps::drift, "Slope of the mean, unit/s.");
  map("amplitude", &LockinMaps::amplitude, "Amplitude at the load frequency.");
  map("phase", &LockinMaps::phase, "rad.");
  c.def_property_readonly(
      "phase_after_load",
      [](const LockinMaps& maps) {
        return taken_over(thermography::phase_after_load(maps), {maps.height, maps.width});
      },
      "Phase relative to that of the load, rad in [-pi, pi].");
  map("in_phase", &LockinMaps::in_phase,
      "Component in phase with the load, signed: positive if a pixel warms as the load rises.");
  map("quadrature", &LockinMaps::quadrature, "Component a quarter of a cycle off the load.");
  map("standard_error", &LockinMaps::standard_error, "Of `in_phase`.");
  map("noise_floor", &LockinMaps::noise_floor, "Mean amplitude due to noise alone.");
  map("second_harmonic", &LockinMaps::second_harmonic, "Amplitude at twice the frequency: slip, plasticity.");
  map("residual", &LockinMaps::residual, "Root mean square residual of the fit.");
}

void bind_grains(py::module_& m) {
  py::class_<PictureGrains> g(
      m, "PictureGrains",
      "Grains found in a picture, in pixels; the pixel in column c and row r has its centre at (c, r).");
  g.def("__len__", &PictureGrains::size, "Number of grains.");
  coordinate_property(
      g, "x", [](const PictureGrains& p) -> auto& { return p.centre; }, &Vec2::x, "Centres, pixels.");
  coordinate_property(
      g, "y", [](const PictureGrains& p) -> auto& { return p.centre; }, &Vec2::y, "Centres, pixels, downwards.");
  array_property(
      g, "radius", [](const PictureGrains& p) -> auto& { return p.radius; }, "Pixels.");
  array_property(
      g, "position_error", [](const PictureGrains& p) -> auto& { return p.position_error; },
      "Standard error of the centre along one axis, pixels.");
  array_property(
      g, "radius_error", [](const PictureGrains& p) -> auto& { return p.radius_error; }, "Pixels.");
  array_property(
      g, "brightness", [](const PictureGrains& p) -> auto& { return p.brightness; },
      "Mean over the inner half of the disk.");
  array_property(
      g, "score", [](const PictureGrains& p) -> auto& { return p.score; }, "Fraction of the rim that shows an edge.");
  array_property(
      g, "material", [](const PictureGrains& p) -> auto& { return p.material; },
      "Class by brightness, darkest first; -1 unknown.");
  array_property(
      g, "size_class", [](const PictureGrains& p) -> auto& { return p.size_class; },
      "Class by radius, smallest first.");
}

void bind_motion(py::module_& m) {
  py::class_<GrainMotion> c(m, "GrainMotion",
                            "Motion of every grain at the load frequency f, pixels, y down: x(t) = x + cos_x cos(2 pi "
                            "f t) + sin_x sin(2 pi f t), t in s after the first frame.");
  c.def("__len__", &GrainMotion::size, "Number of grains.");
  coordinate_property(
      c, "cos_x", [](const GrainMotion& p) -> auto& { return p.cosine; }, &Vec2::x, "Pixels.");
  coordinate_property(
      c, "sin_x", [](const GrainMotion& p) -> auto& { return p.sine; }, &Vec2::x, "Pixels.");
  coordinate_property(
      c, "cos_y", [](const GrainMotion& p) -> auto& { return p.cosine; }, &Vec2::y, "Pixels.");
  coordinate_property(
      c, "sin_y", [](const GrainMotion& p) -> auto& { return p.sine; }, &Vec2::y, "Pixels.");
  array_property(
      c, "error", [](const GrainMotion& p) -> auto& { return p.error; },
      "Standard error of each of the four, pixels; infinite for a grain that shows no contrast.");
  c.def_property_readonly(
      "lost", [](const GrainMotion& motion) { return taken_over_as_bool(thermography::lost_grains(motion)); },
      "True for grains that are not visible enough in the film to be tracked.");
}

}  // namespace

void bind_maps(py::module_& m) {
  bind_lockin_maps(m);
  bind_grains(m);
  bind_motion(m);
}

}  // namespace arenite::python
