#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <iterator>

#include "arrays.hpp"
#include "calls.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/friction.hpp"
#include "grains/fields/nonaffine.hpp"
#include "grains/fields/steady_state.hpp"
#include "keywords.hpp"
#include "module.hpp"

namespace arenite::python {
namespace {

using Shape = std::vector<py::ssize_t>;

/// What functions of few choices ask.
struct Neighbourhood {
  double range = 0;
};
void declare(ParameterVisitor& v, Neighbourhood& asked) {
  v.number({"range", "Distance up to which grains are neighbours.", true}, asked.range, "m", range::positive);
}

struct SurfaceAsked {
  double gravity_angle = 0, gap = 0.1;
};
void declare(ParameterVisitor& v, SurfaceAsked& asked) {
  v.number({"gravity_angle", "Angle of gravity from straight down, counter-clockwise."}, asked.gravity_angle, "rad",
           range::any);
  v.number({"gap", "Grains are connected whose surfaces are nearer than this, in mean diameters."}, asked.gap, "",
           range::not_negative);
}

template <int D> py::array_t<double> vectors(const std::vector<Vec<D>>& values, Shape shape) {
  std::vector<double> flat;
  for (const Vec<D>& v : values)
    for (int axis = 0; axis < D; ++axis) flat.push_back(v[axis]);
  shape.push_back(D);
  return taken_over(std::move(flat), std::move(shape));
}

py::array_t<double> tensors(const std::vector<Tensor2>& values, Shape shape) {
  std::vector<double> flat;
  for (const Tensor2& t : values) flat.insert(flat.end(), {t.xx, t.xy, t.yx, t.yy});
  shape.insert(shape.end(), {2, 2});
  return taken_over(std::move(flat), std::move(shape));
}

py::array_t<double> tensors(const std::vector<Tensor3>& values, Shape shape) {
  std::vector<double> flat;
  for (const Tensor3& t : values)
    for (const auto& row : t.at) flat.insert(flat.end(), std::begin(row), std::end(row));
  shape.insert(shape.end(), {3, 3});
  return taken_over(std::move(flat), std::move(shape));
}

const Keywords& coarse_keywords() {
  static const Keywords keywords(recipe::every_key<fields::CoarseGraining>(), {{"width", "width", "", true},
                                                                               {"spacing", "spacing", "", true},
                                                                               {"kernel", "kernel"},
                                                                               {"tilt_rate", "tilt_rate"}});
  return keywords;
}

template <int D>
py::dict coarse_grained(const PackingIn<D>& packing, const Quantity& width, const std::optional<Quantity>& spacing,
                        const py::kwargs& more) {
  auto given = coarse_keywords().given("coarse_grained", more);
  given.push_back(coarse_keywords().given("width", width));
  if (spacing) given.push_back(coarse_keywords().given("spacing", *spacing));
  fields::CoarseGraining choice;
  read_keywords(choice, given);
  Call call;
  if (packing.domain.tilt != 0 && !choice.tilt_rate)
    call.warn(
        "the cell is tilted, and a packing does not know how fast: velocities across its sides are taken as of a cell "
        "at rest; give tilt_rate, shear rate times height (0 if it is at rest)");
  auto f = call.without_lock([&] { return fields::coarse_grain(packing, choice); });
  Shape shape;
  for (int axis = D - 1; axis >= 0; --axis) shape.push_back(f.grid.count[axis]);
  py::dict d;
  constexpr std::array names{"x", "y", "z"};
  for (int axis = 0; axis < D; ++axis) d[names[static_cast<std::size_t>(axis)]] = taken_over(f.grid.lines(axis));
  d["density"] = taken_over(std::move(f.density), shape);
  d["solid_fraction"] = taken_over(std::move(f.solid_fraction), shape);
  d["velocity"] = vectors<D>(f.velocity, shape);
  d["velocity_gradient"] = tensors(f.velocity_gradient, shape);
  d["contact_stress"] = tensors(f.contact_stress, shape);
  d["kinetic_stress"] = tensors(f.kinetic_stress, shape);
  d["gradient_stress"] = tensors(f.gradient_stress, shape);
  d["wall_force"] = vectors<D>(f.wall_force, shape);
  return d;
}

const Keywords& nonaffine_keywords() {
  static const Keywords keywords(recipe::every_key<Neighbourhood>(), {{"range", "range", "", true}});
  return keywords;
}

py::dict nonaffine(const Packing& before, const Packing& after, const Quantity& range, const py::kwargs& more) {
  auto given = nonaffine_keywords().given("nonaffine", more);
  given.push_back(nonaffine_keywords().given("range", range));
  Neighbourhood asked;
  read_keywords(asked, given);
  Call call;
  auto [local, global] = call.without_lock([&] {
    return std::pair(fields::local_deformation(before, after, asked.range), fields::affine_fit(before, after));
  });
  const Shape grains{static_cast<py::ssize_t>(local.d2min.size())};
  py::dict d;
  d["neighbours"] = taken_over(std::move(local.neighbours));
  d["strain"] = tensors(local.strain, grains);
  d["rotation"] = taken_over(std::move(local.rotation));
  d["d2min"] = taken_over(std::move(local.d2min));
  d["gradient"] = tensors({global.gradient}, {});
  d["residual"] = vectors<2>(global.residual, grains);
  d["fluctuation"] = global.fluctuation;
  return d;
}

const Keywords& friction_keywords() {
  static const Keywords keywords(recipe::every_key<fields::FrictionOptions>(),
                                 {{"mu", "friction", "", true}, {"wall_mu", "wall_friction"}});
  return keywords;
}

py::dict friction(const Packing& packing, const Quantity& mu, const py::kwargs& more) {
  auto given = friction_keywords().given("friction_state", more);
  given.push_back(friction_keywords().given("mu", mu));
  fields::FrictionOptions options;
  read_keywords(options, given);
  Call call;
  auto found = call.without_lock([&] { return fields::measure_friction(packing, options); });
  py::dict d;
  d["mobilisation"] = taken_over(std::move(found.mobilisation));
  d["power_W"] = taken_over(std::move(found.power));
  d["mean"] = py::make_tuple(found.mean.value, found.mean.error);
  d["sliding"] = py::make_tuple(found.sliding.value, found.sliding.error);
  d["total_power_W"] = found.total_power;
  return d;
}

py::dict steady(const ArrayLike& series) {
  const std::vector<double> values = to_vector(series, "series");
  const auto found = fields::find_steady_state(values);
  py::dict d;
  d["reached"] = found.reached;
  d["first"] = found.first;
  d["mean"] = found.mean.value;
  d["error"] = found.mean.error;
  const auto interval = statistics::confidence_95(found.mean);
  d["low_95"] = interval.low;
  d["high_95"] = interval.high;
  d["deviation"] = found.deviation;
  return d;
}

py::dict discharge(const ArrayLike& time, const ArrayLike& passed) {
  const auto found = fields::find_discharge(to_vector(time, "time"), to_vector(passed, "passed"));
  py::dict d;
  d["steady"] = found.steady;
  d["rate"] = py::make_tuple(found.rate.value, found.rate.error);
  d["begin"] = found.begin;
  d["end"] = found.end;
  d["stopped"] = found.stopped;
  return d;
}

const Keywords& surface_keywords() {
  static const Keywords keywords(recipe::every_key<SurfaceAsked>(),
                                 {{"gravity_angle", "gravity_angle"}, {"gap", "gap"}});
  return keywords;
}

template <int D> py::dict free_surface(const PackingIn<D>& packing, const py::kwargs& more) {
  SurfaceAsked asked;
  read_keywords(asked, surface_keywords().given("free_surface", more));
  const Vec2 down{std::sin(asked.gravity_angle), -std::cos(asked.gravity_angle)};
  Call call;
  auto found = call.without_lock([&] { return fields::find_free_surface(packing, down, asked.gap); });
  const auto angle = [](const statistics::Estimate& e) { return py::make_tuple(e.value, e.error); };
  py::dict d;
  d["place"] = taken_over(std::move(found.place));
  d["height"] = taken_over(std::move(found.height));
  d["grains"] = found.grains;
  d["left"] = found.left;
  d["right"] = found.right;
  d["bottom"] = found.bottom;
  d["top"] = found.top;
  d["angle"] = angle(found.angle);
  d["left_angle"] = angle(found.left_flank.angle);
  d["right_angle"] = angle(found.right_flank.angle);
  return d;
}

}  // namespace

void bind_grain_fields(py::module_& m) {
  m.def("discharge", &discharge, py::arg("time"), py::arg("passed"),
        "Discharge rate from the amounts passed at given times (`passed_mass` of a history): rate (value, error) of "
        "the steady part between begin and end (s), without its onset and end; steady: whether there is such a part; "
        "otherwise the rate has no error; stopped: whether nothing passes any more in the end.");
  def_with_keywords(
      m, "free_surface", &free_surface<2>, surface_keywords(),
      "Surface of the largest connected set of grains: position and height (m) of its upper rim, grains, left, right, "
      "bottom, top (m), and the angle of its flanks in rad by a line through the middle of their height, each (value, "
      "error).",
      py::arg("packing"));
  def_with_keywords(m, "free_surface", &free_surface<3>, surface_keywords(),
                    "The same of spheres, heights as means over the depth; no angle of a heap that does not reach from "
                    "the back to the front.",
                    py::arg("packing"));
  def_with_keywords(
      m, "coarse_grained", &coarse_grained<2>, coarse_keywords(),
      "Coarse-grained fields of a state (Goldhirsch 2010) on a grid of points x, y (m), arrays of rows from below: "
      "density (kg/m^3), solid_fraction, velocity (m/s), velocity_gradient (1/s), contact_stress, kinetic_stress of "
      "fluctuations about the mean flow, and gradient_stress of its own differences within the width (Pa, tension "
      "positive), wall_force (N/m^3).",
      py::arg("packing"), py::arg("width"), py::arg("spacing") = py::none());
  def_with_keywords(
      m, "coarse_grained", &coarse_grained<3>, coarse_keywords(),
      "The same of spheres on points x, y, z: arrays of layers from the back, of rows from below; vectors and tensors "
      "have three components along each last axis. At most 4 million points.",
      py::arg("packing"), py::arg("width"), py::arg("spacing") = py::none());
  def_with_keywords(m, "nonaffine", &nonaffine, nonaffine_keywords(),
                    "Deformation between two states of the same grains: strain and rotation of every grain's "
                    "surroundings, d2min (m^2, mean over neighbours; Falk and Langer 1998), and of all grains the "
                    "gradient, residual displacements (m) and their root mean square, fluctuation.",
                    py::arg("before"), py::arg("after"), py::arg("range"));
  def_with_keywords(
      m, "friction_state", &friction, friction_keywords(),
      "Friction at the contacts: mobilisation (tangential force over mu times the normal one) and power_W of each; "
      "mean and sliding (fraction of contacts that slide), each (value, error); total_power_W.",
      py::arg("packing"), py::arg("mu"));
  m.def("steady_state", &steady, py::arg("series"),
        "The stationary part of an evenly sampled series, in which it only fluctuates: reached, first (sample), mean "
        "with its error, which allows for correlation, low_95 and high_95, deviation.");
}

}  // namespace arenite::python
