#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "arrays.hpp"
#include "calls.hpp"
#include "imaging/circles.hpp"
#include "imaging/proposed_contacts.hpp"
#include "inference/contact_forces.hpp"
#include "io/film.hpp"
#include "module.hpp"
#include "thermography/lockin.hpp"
#include "thermography/step_load.hpp"

namespace arenite::python {
namespace {

/// Frames in an array of Python's, which is looked at and not copied.
class ArrayFilm : public FilmSource {
 public:
  ArrayFilm(const py::array& frames, double rate, std::vector<double> time) {
    if (frames.ndim() != 3) throw InputError("a film is an array (frames, height, width)");
    if (py::isinstance<py::array_t<std::uint16_t>>(frames)) held_ = py::array_t<std::uint16_t, py::array::c_style>::ensure(frames);
    else held_ = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(frames);
    info_.floating = held_.itemsize() == 4;
    info_.frames = held_.shape(0);
    info_.height = static_cast<int>(held_.shape(1));
    info_.width = static_cast<int>(held_.shape(2));
    info_.frame_rate = rate;
    info_.time = std::move(time);
    info_.format = "array";
    data_ = held_.data();
  }
  const FilmInfo& info() const override { return info_; }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const std::size_t begin = static_cast<std::size_t>(first) * info_.pixels(), end = begin + count * info_.pixels();
    block.first = first;
    block.frames = count;
    if (info_.floating) block.value.assign(values_in_memory() + begin, values_in_memory() + end);
    else block.level.assign(levels_in_memory() + begin, levels_in_memory() + end);
  }
  const std::uint16_t* levels_in_memory() const override { return info_.floating ? nullptr : static_cast<const std::uint16_t*>(data_); }
  const float* values_in_memory() const override { return info_.floating ? static_cast<const float*>(data_) : nullptr; }

 private:
  py::array held_;
  const void* data_ = nullptr;
  FilmInfo info_;
};

std::unique_ptr<FilmSource> film_of(const py::object& film, double frame_rate, const py::object& time) {
  if (!py::isinstance<py::array>(film)) {
    io::FilmChoice choice;
    if (frame_rate > 0) choice.frame_rate = frame_rate;
    return io::open_film(py::str(film).cast<std::string>(), choice);
  }
  return std::make_unique<ArrayFilm>(film, frame_rate, time.is_none() ? std::vector<double>{} : to_vector<double>(time));
}

LockinMaps locked_in(const py::object& film, double frequency, double frame_rate, const py::object& time, bool refine, int drift_order, int harmonics, bool full_swing,
                     const py::object& reference_phase, bool nearest_bin, int threads) {
  const auto source = film_of(film, frame_rate, time);
  thermography::LockinOptions o;
  o.frequency = frequency;
  o.refine = refine;
  o.drift_order = drift_order;
  o.harmonics = harmonics;
  o.convention = full_swing ? SwingConvention::full : SwingConvention::half;
  o.frame_rate = frame_rate;
  o.threads = threads;
  if (!reference_phase.is_none()) o.reference_phase = reference_phase.cast<double>();
  Call call;
  o.progress = [&](double) { return !call.asked_to_stop(); };
  return call.without_lock([&] { return nearest_bin ? thermography::nearest_bin_transform(*source, o) : thermography::lock_in(*source, o); });
}

py::dict stepped(const py::object& film, const py::object& time, double rise, double window, int drift_order, double frame_rate) {
  const auto source = film_of(film, frame_rate, py::none());
  thermography::StepOptions o;
  if (!time.is_none()) o.time = time.cast<double>();
  o.rise = rise;
  o.window = window;
  o.drift_order = drift_order;
  o.frame_rate = frame_rate;
  Call call;
  o.progress = [&](double) { return !call.asked_to_stop(); };
  const auto maps = call.without_lock([&] { return thermography::step_load(*source, o); });
  const auto map = [&](const std::vector<float>& values) { return py::array_t<float>({maps.height, maps.width}, values.data()); };
  py::dict d;
  d["time"] = maps.time;
  d["jump"] = map(maps.jump);
  d["standard_error"] = map(maps.standard_error);
  d["residual"] = map(maps.residual);
  return d;
}

py::dict film_info(const std::string& path) {
  const auto film = io::open_film(path);
  const FilmInfo& i = film->info();
  py::dict d;
  d["width"] = i.width;
  d["height"] = i.height;
  d["frames"] = i.frames;
  d["frame_rate"] = i.frame_rate;
  d["integration"] = i.integration;
  d["bits"] = i.bits;
  d["format"] = i.format;
  d["camera"] = i.camera;
  return d;
}

py::array film_frames(const std::string& path, std::int64_t first, std::int64_t count) {
  const auto film = io::open_film(path);
  const FilmInfo& i = film->info();
  if (first < 0 || first >= i.frames) throw InputError(path, 0, "the film has frames 0 to " + std::to_string(i.frames - 1));
  count = std::min(count, i.frames - first);
  FrameBlock block;
  Call call;
  call.without_lock([&] { film->read(first, static_cast<std::size_t>(count), block); return 0; });
  const std::vector<py::ssize_t> shape{count, i.height, i.width};
  if (i.floating) return py::array_t<float>(shape, block.value.data());
  return py::array_t<std::uint16_t>(shape, block.level.data());
}

PictureGrains circles(const py::array_t<float, py::array::c_style | py::array::forcecast>& image, const std::vector<double>& radii, double smallest, double largest,
                      std::size_t materials, const std::string& contrast) {
  if (image.ndim() != 2) throw InputError("a picture is an array (height, width)");
  FloatImage picture{static_cast<int>(image.shape(1)), static_cast<int>(image.shape(0)), {image.data(), image.data() + image.size()}};
  imaging::CircleOptions o;
  o.radii = radii;
  o.smallest = smallest;
  o.largest = largest;
  o.materials = materials;
  if (contrast == "bright") o.contrast = imaging::GrainContrast::bright;
  else if (contrast == "dark") o.contrast = imaging::GrainContrast::dark;
  else if (contrast != "found") throw InputError("contrast is \"found\", \"bright\" or \"dark\"");
  Call call;
  return call.without_lock([&] { return imaging::find_circles(picture, o).grains; });
}

Packing touching(const Packing& packing, double position_error, double radius_error) {
  Packing result = packing;
  const std::size_t n = packing.grains.size();
  result.contacts = imaging::propose_contacts(packing.grains, packing.domain, {std::vector<double>(n, position_error), std::vector<double>(n, radius_error)});
  return result;
}

py::dict inferred(const Packing& packing, const py::object& picture, const py::object& error, double pixel, std::pair<double, double> first, std::vector<double> factor,
                  const std::map<std::string, double>& walls, double blur) {
  using Pixels = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const Pixels value = Pixels::ensure(picture), errors = Pixels::ensure(error);
  if (!value || !errors || value.ndim() != 2 || errors.size() != value.size()) throw InputError("the swing and its error are arrays (height, width)");
  inference::SwingPicture p{static_cast<int>(value.shape(1)), static_cast<int>(value.shape(0)), pixel, {first.first, first.second},
                            {value.data(), value.data() + value.size()}, {errors.data(), errors.data() + errors.size()}};
  inference::ForceProblem problem{packing, std::move(factor), {}};
  for (int side = 0; side < 4; ++side)
    if (const auto at = walls.find(side_names[static_cast<std::size_t>(side)]); at != walls.end()) problem.walls.push_back({side, at->second, std::max(1e-3 * std::abs(at->second), 1e-6)});
  inference::ForceOptions o;
  o.blur = blur;
  Call call;
  const InferredForces f = call.without_lock([&] { return inference::infer_from_pixels(problem, p, o); });
  const auto array = [](const std::vector<double>& values) { return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data()); };
  py::dict d;
  d["fn"] = array(f.contacts.fn);
  d["ft"] = array(f.contacts.ft);
  d["fn_error"] = array(f.fn_error);
  d["ft_error"] = array(f.ft_error);
  d["spurious"] = array(f.spurious).attr("astype")("bool");
  d["residual"] = f.residual;
  return d;
}

void bind_maps(py::module_& m) {
  py::class_<LockinMaps> c(m, "LockinMaps", "What a lock-in finds in every pixel, in the film's unit; arrays are (height, width), the top row first.");
  c.def_readonly("frequency", &LockinMaps::frequency, "Hz, refined on the film.")
      .def_readonly("frequency_error", &LockinMaps::frequency_error, "Hz.")
      .def_readonly("reference_phase", &LockinMaps::reference_phase, "rad.")
      .def_readonly("frames", &LockinMaps::frames)
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
  py::class_<PictureGrains> g(m, "PictureGrains", "Grains found in a picture, in pixels; the pixel in column c and row r has its centre at (c, r).");
  g.def("__len__", &PictureGrains::size);
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

}  // namespace

void bind_film(py::module_& m) {
  bind_maps(m);
  m.def("lock_in", &locked_in, py::arg("film"), py::arg("frequency"), py::kw_only(), py::arg("frame_rate") = 0.0, py::arg("time") = py::none(), py::arg("refine") = true,
        py::arg("drift_order") = 2, py::arg("harmonics") = 2, py::arg("full_swing") = false, py::arg("reference_phase") = py::none(), py::arg("nearest_bin") = false,
        py::arg("threads") = 1,
        "Lock-in of a film: a file, or an array (frames, height, width), uint16 or float32, which is not copied, with its `frame_rate` (Hz) or the `time` of every frame (s). Least squares "
        "on polynomial drift and harmonics with the frequency (Hz) refined on the film; `nearest_bin`: the plain transform of T 1.4.");
  m.def("step_load", &stepped, py::arg("film"), py::kw_only(), py::arg("time") = py::none(), py::arg("rise") = 0.0, py::arg("window") = 0.0, py::arg("drift_order") = 1,
        py::arg("frame_rate") = 0.0, "The jump of every pixel at a step of the load (s after the first frame; found on the film if not given): time, jump, standard_error, residual.");
  m.def("film_info", &film_info, py::arg("path"), "What a film says about itself: width, height, frames, frame_rate (Hz), integration (s), bits, format, camera.");
  m.def("read_film", &film_frames, py::arg("path"), py::arg("first") = 0, py::arg("count") = 1, "Frames of a film as an array (frames, height, width), top row first.");
  m.def("find_grains", &circles, py::arg("image"), py::kw_only(), py::arg("radii") = std::vector<double>{}, py::arg("smallest") = 2.5, py::arg("largest") = 0.0,
        py::arg("materials") = 0, py::arg("contrast") = "found",
        "Circles in a picture (height, width): centres, radii, material by brightness. `radii`: of the size classes, pixels, if they are known; `materials`: number of brightnesses.");
  m.def("propose_contacts", &touching, py::arg("packing"), py::kw_only(), py::arg("position_error") = 0.0, py::arg("radius_error") = 0.0,
        "The packing with contacts where surfaces are no farther apart than three standard errors (m); forces are 0.");
  m.def("infer_forces", &inferred, py::arg("packing"), py::arg("swing"), py::arg("error"), py::kw_only(), py::arg("pixel"), py::arg("first"), py::arg("factor"),
        py::arg("walls") = std::map<std::string, double>{}, py::arg("blur") = 0.5,
        "Contact forces (N) from a picture of the full thermoelastic swing (K, rows from the top): `pixel` (m), `first`: centre of the upper left pixel (m), `factor`: A of every "
        "material (K/Pa), `walls`: swing of wall forces by side (N, taken as known to 0.1 %). Gives fn, ft, fn_error, ft_error, spurious, residual.");
}

}  // namespace arenite::python
