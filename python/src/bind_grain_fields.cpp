#include <pybind11/stl.h>

#include <cmath>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/error.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/force_chains.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/friction.hpp"
#include "grains/fields/loops.hpp"
#include "grains/fields/nonaffine.hpp"
#include "grains/fields/steady_state.hpp"
#include "module.hpp"

namespace arenite::python {
namespace {

using Shape = std::vector<py::ssize_t>;

py::array_t<double> vectors(const std::vector<Vec2>& values, Shape shape) {
  std::vector<double> flat;
  for (const Vec2& v : values) flat.insert(flat.end(), {v.x, v.y});
  shape.push_back(2);
  return taken_over(std::move(flat), std::move(shape));
}

py::array_t<double> tensors(const std::vector<Tensor2>& values, Shape shape) {
  std::vector<double> flat;
  for (const Tensor2& t : values) flat.insert(flat.end(), {t.xx, t.xy, t.yx, t.yy});
  shape.insert(shape.end(), {2, 2});
  return taken_over(std::move(flat), std::move(shape));
}

py::dict coarse_grained(const Packing& packing, const Quantity& width, const std::optional<Quantity>& spacing,
                        const std::string& kernel, const std::optional<double>& tilt_rate) {
  fields::CoarseGraining choice;
  choice.width = width.si(dimension::length, "width");
  choice.tilt_rate = tilt_rate;
  if (kernel != "lucy" && kernel != "gaussian")
    throw InputError("kernel \"" + kernel + "\" is neither \"lucy\" nor \"gaussian\"");
  choice.kernel = kernel == "lucy" ? fields::KernelShape::lucy : fields::KernelShape::gaussian;
  const double between = spacing ? spacing->si(dimension::length, "spacing") : choice.width;
  Call call;
  auto f = call.without_lock(
      [&] { return fields::coarse_grain(packing, fields::grid_over(packing.domain, between), choice); });
  const Shape shape{f.grid.rows, f.grid.columns};
  std::vector<double> x, y;
  for (int c = 0; c < f.grid.columns; ++c) x.push_back(f.grid.point(c, 0).x);
  for (int r = 0; r < f.grid.rows; ++r) y.push_back(f.grid.point(0, r).y);
  py::dict d;
  d["x"] = taken_over(std::move(x));
  d["y"] = taken_over(std::move(y));
  d["density"] = taken_over(std::move(f.density), shape);
  d["solid_fraction"] = taken_over(std::move(f.solid_fraction), shape);
  d["velocity"] = vectors(f.velocity, shape);
  d["velocity_gradient"] = tensors(f.velocity_gradient, shape);
  d["contact_stress"] = tensors(f.contact_stress, shape);
  d["kinetic_stress"] = tensors(f.kinetic_stress, shape);
  d["gradient_stress"] = tensors(f.gradient_stress, shape);
  d["wall_force"] = vectors(f.wall_force, shape);
  return d;
}

py::dict force_chains(const Packing& packing, double stress_factor, double angle, std::size_t least) {
  Call call;
  const auto found = call.without_lock([&] {
    return fields::find_force_chains(packing, {stress_factor, angle, least});
  });
  py::dict d;
  d["chains"] = found.chains;
  d["mean_length"] = found.mean_length;
  d["grain_share"] = found.grain_share;
  d["mean_stress_Pa"] = found.mean_stress;
  return d;
}

py::dict strong_clusters(const Packing& packing, double factor) {
  Call call;
  auto found = call.without_lock([&] { return fields::strong_clusters(packing, factor); });
  py::dict d;
  d["threshold_N"] = found.threshold;
  d["share"] = found.share;
  d["grains"] = found.grains;
  d["contacts"] = found.contacts_of;
  d["of"] = taken_over(std::move(found.of));
  return d;
}

py::dict loops(const Packing& packing, bool bearing_only) {
  Call call;
  auto found = call.without_lock([&] { return fields::find_loops(packing, bearing_only); });
  py::dict d;
  d["mean_edges"] = found.mean_edges;
  d["rattlers"] = found.rattlers;
  d["histogram"] = found.histogram;
  d["edges"] = taken_over(std::move(found.edges));
  d["area"] = taken_over(std::move(found.area));
  return d;
}

py::dict nonaffine(const Packing& before, const Packing& after, const Quantity& range) {
  const double reach = range.si(dimension::length, "range");
  Call call;
  auto [local, global] = call.without_lock(
      [&] { return std::pair(fields::local_deformation(before, after, reach), fields::affine_fit(before, after)); });
  const Shape grains{static_cast<py::ssize_t>(local.d2min.size())};
  py::dict d;
  d["neighbours"] = taken_over(std::move(local.neighbours));
  d["strain"] = tensors(local.strain, grains);
  d["rotation"] = taken_over(std::move(local.rotation));
  d["d2min"] = taken_over(std::move(local.d2min));
  d["gradient"] = tensors({global.gradient}, {});
  d["residual"] = vectors(global.residual, grains);
  d["fluctuation"] = global.fluctuation;
  return d;
}

py::dict friction(const Packing& packing, double mu, const std::optional<double>& wall_mu) {
  Call call;
  auto found = call.without_lock([&] { return fields::measure_friction(packing, {mu, wall_mu}); });
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

py::dict free_surface(const Packing& packing, const Quantity& gravity_angle, double gap) {
  const double turned = gravity_angle.si(dimension::none, "gravity_angle");
  Call call;
  auto found = call.without_lock([&] {
    return fields::find_free_surface(packing, {std::sin(turned), -std::cos(turned)}, gap);
  });
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
  m.def("free_surface", &free_surface, py::arg("packing"), py::kw_only(), py::arg("gravity_angle") = 0.0,
        py::arg("gap") = 0.1,
        "Surface of the largest connected set of grains (surfaces nearer than `gap` mean diameters): position and "
        "height (m) of its upper rim, grains, left, right, bottom, top (m), and the angle of its flanks in rad by a "
        "line through the middle of their height, each (value, error). `gravity_angle`: angle of gravity from straight "
        "down, counter-clockwise, rad or text with a unit.");
  m.def("coarse_grained", &coarse_grained, py::arg("packing"), py::arg("width"), py::arg("spacing") = py::none(),
        py::kw_only(), py::arg("kernel") = "lucy", py::arg("tilt_rate") = py::none(),
        "Coarse-grained fields of a state (Goldhirsch 2010) on a grid of points x, y (m), arrays of rows from below: "
        "density (kg/m^3), solid_fraction, velocity (m/s), velocity_gradient (1/s), contact_stress, kinetic_stress of "
        "fluctuations about the mean flow, and gradient_stress of its own differences within the width (Pa, tension "
        "positive), wall_force (N/m^3). `width`: standard deviation of the kernel, m or text with a unit; `spacing` of "
        "the points, the width unless given; `tilt_rate` of a sheared cell, m/s.");
  m.def("force_chains", &force_chains, py::arg("packing"), py::kw_only(), py::arg("stress_factor") = 1.0,
        py::arg("angle") = 45.0, py::arg("least") = 3,
        "Force chains (Peters et al. 2005): chains (lists of grains in order), mean_length (grains), grain_share, "
        "mean_stress_Pa. `stress_factor`: of the mean major principal stress; `angle`, degrees; `least` grains of a "
        "chain.");
  m.def("strong_clusters", &strong_clusters, py::arg("packing"), py::kw_only(), py::arg("factor") = 1.0,
        "Clusters of grains joined by contacts above `factor` times the mean force, the largest first: threshold_N, "
        "fraction of strong contacts, grains and contacts of each, of (cluster of every grain, -1: none).");
  m.def("loops", &loops, py::arg("packing"), py::kw_only(), py::arg("bearing_only") = true,
        "Smallest cycles of the contact network without rattlers: edges (contacts of each), area (m^2), histogram by "
        "number of contacts, mean_edges.");
  m.def("nonaffine", &nonaffine, py::arg("before"), py::arg("after"), py::arg("range"),
        "Deformation between two states of the same grains: strain and rotation of every grain's surroundings within "
        "`range` (m or text with a unit), d2min (m^2, mean over neighbours; Falk and Langer 1998), and of all grains "
        "the gradient, residual displacements (m) and their root mean square, fluctuation.");
  m.def("friction_state", &friction, py::arg("packing"), py::arg("mu"), py::arg("wall_mu") = py::none(),
        "Friction at the contacts: mobilisation (tangential force over mu times the normal one) and power_W of each; "
        "mean and sliding (fraction of contacts that slide), each (value, error); total_power_W.");
  m.def("steady_state", &steady, py::arg("series"),
        "The stationary part of an evenly sampled series, in which it only fluctuates: reached, first (sample), mean "
        "with its error, which allows for correlation, low_95 and high_95, deviation.");
}

}  // namespace arenite::python
