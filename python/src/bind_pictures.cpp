#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/fields/loading.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/page_document.hpp"
#include "report/print/animation.hpp"
#include "thermal/inference/film_fit.hpp"
#include "thermal/inference/film_maps.hpp"

/// What pictures are drawn from.
namespace arenite::python {
namespace {

namespace figures = report::figures;

/// Vectors as rows.
template <int D> py::array_t<double> rows_of_vectors(const std::vector<Vec<D>>& values) {
  std::vector<double> flat;
  for (const Vec<D>& v : values)
    for (int axis = 0; axis < D; ++axis) flat.push_back(v[axis]);
  return taken_over(std::move(flat), {static_cast<py::ssize_t>(values.size()), D});
}

template <int D>
py::list displacements_of(const std::vector<const PackingIn<D>*>& packings, const std::vector<double>& shear_strain) {
  if (!shear_strain.empty() && shear_strain.size() != packings.size())
    throw refusal("there are {} packings and {} shear strains; give as many", packings.size(), shear_strain.size());
  std::vector<texture::ShearedIn<D>> states;
  for (std::size_t k = 0; k < packings.size(); ++k)
    states.push_back({packings[k], shear_strain.empty() ? 0 : shear_strain[k]});
  Call call;
  const auto ways = call.without_lock([&] { return texture::displacements(states); });
  py::list list;
  for (const auto& way : ways) list.append(rows_of_vectors<D>(way));
  return list;
}

template <class Packing_> py::array_t<double> values_of_grains(const Packing_& packing, const std::string& name) {
  Call call;
  return taken_over(call.without_lock([&] { return texture::values_of(packing, name); }));
}

template <class Packing_>
py::array_t<double> mobilisations_of(const Packing_& packing, std::optional<double> friction) {
  Call call;
  return taken_over(call.without_lock([&] { return texture::mobilisations(packing, friction); }));
}

/// Coarse-grained fields as pictures show them, on a grid whose lines are at x, y and, in space, z.
template <int D> py::dict layers_of(const StageResultIn<D>& stage, const SnapshotIn<D>& state) {
  Call call;
  const auto f = call.without_lock([&] {
    return fields::fields_to_show(state.packing, fields::shear_rate_at(stage.history, state.time),
                                  fields::grid_to_show(state.packing));
  });
  constexpr std::array names{"x", "y", "z"};
  std::vector<py::ssize_t> shape;
  py::dict d;
  for (int axis = D - 1; axis >= 0; --axis) shape.push_back(f.grid.count[axis]);
  for (int axis = 0; axis < D; ++axis) d[names[static_cast<std::size_t>(axis)]] = taken_over(f.grid.lines(axis));
  for (const auto& layer : fields::coarse_layers<D>())
    if (fields::has_layer(layer, f)) d[py::str(layer.name)] = taken_over(fields::values_of(layer, f), shape);
  return d;
}

/// Layers of the plane or of space.
template <int D> void bind_layers_of(py::module_& m, const char* layers) {
  m.def(
      layers, [] { return to_python(report::named_kinds(fields::coarse_layers<D>())); },
      "{name: [label, symbol, unit, formula, scale of colours]} of pictures of coarse-grained fields.");
  m.def("_layers_of_state", &layers_of<D>, py::arg("stage"), py::arg("state"),
        "Coarse-grained fields of a state by their names, (layers,) rows from below, and x, y (, z) of their places.");
}

template <class Work> std::pair<double, double> scale_of(Work&& work) {
  Call call;
  const texture::ForceScale scale = call.without_lock(work);
  return {scale.mean, scale.tension};
}

/// Keywords of arenite.animate.save.
const Keywords& animation_keywords() {
  static const Keywords keywords{recipe::every_key<report::Animation>(),
                                 {{"by", "by"},
                                  {"chains", "chains"},
                                  {"stage", "stage"},
                                  {"colour_map", "map"},
                                  {"low", "low", "", true},
                                  {"high", "high", "", true},
                                  {"fps", "fps"},
                                  {"size", "size"},
                                  {"curve", "curve"}}};
  return keywords;
}

py::dict animation_of(const py::kwargs& given) {
  report::Animation animation;
  read_keywords(animation, animation_keywords().given("save", given));
  const report::PictureSize size = report::size_of(animation);
  const auto or_none = [](const std::string& text) { return text.empty() ? py::object(py::none()) : py::str(text); };
  py::dict d;
  const report::Colouring& by = report::colourings()[animation.by];
  d["by"] = by.name;
  d["never_negative"] = by.never_negative;
  d["chains"] = animation.chains;
  d["stage"] = or_none(animation.stage);
  d["colour_map"] = or_none(animation.map);
  d["fps"] = animation.fps;
  d["size"] = py::make_tuple(size.width, size.height);
  return d;
}

void bind_colourings(py::module_& m) {
  def_with_keywords(m, "_animation", &animation_of, animation_keywords(),
                    "What an animation is asked for, as declared, with defaults for what is not given.");
  m.attr("_colourings") =
      py::cast(mapped(report::colourings(), [](const report::Colouring& each) { return std::string(each.name); }));
  m.def(
      "_grain_quantities", [] { return to_python(report::named_kinds(texture::grain_quantities())); },
      "{name: [label, symbol, unit, formula, scale of colours]} of what grains are drawn by.");
  bind_layers_of<2>(m, "_coarse_layers");
  bind_layers_of<3>(m, "_coarse_layers_in_space");
}

void bind_maps_of_films(py::module_& m) {
  m.def(
      "_fit_maps",
      [](const FilmResult& film) {
        Call call;
        auto maps = call.without_lock([&] { return inference::fit_maps(film); });
        py::dict d;
        const auto add = [&](const char* name, std::vector<float>& map) {
          const double rms = inference::root_mean_square(map);
          if (!map.empty())
            d[name] = py::make_tuple(taken_over(std::move(map), {film.film.height, film.film.width}), rms);
        };
        add("measured", maps.measured), add("fitted", maps.fitted), add("residual", maps.residual);
        return d;
      },
      py::arg("film"),
      "{name: (map, its root mean square)} of the warming with the load, of what the forces make of it, and of the "
      "difference, peak to peak; NaN where one of the two is not known. Empty without forces.");
  m.attr("_faint_below") = inference::faint_below;
  m.def(
      "_film_maps",
      [](const FilmResult* film) {
        Call call;
        py::dict all;
        const FilmResult none{};
        for (const inference::FilmMap& map : inference::film_maps()) {
          py::dict one = to_python(inference::words_of(map, film ? *film : none));
          if (film) {
            auto values = call.without_lock([&] { return inference::values_of(map, *film); });
            if (values.empty()) continue;
            one["values"] = taken_over(std::move(values), {film->film.height, film->film.width});
          }
          all[py::str(std::string(map.id))] = one;
        }
        return all;
      },
      py::arg("film") = py::none(),
      "{name: {label, title, unit, around, cyclic, marks, values}} of the maps that a film has, in the order of its "
      "page; without a film what is said of all.");
  m.def(
      "_doubtful_contacts", [](const FilmResult& film) { return taken_over(inference::doubtful_contacts(film)); },
      py::arg("film"), "1 for each contact that counts as there, and by its force and its gap may not be.");
}

void bind_numbers_of_grains(py::module_& m) {
  const char *values =
                 "A number of every grain: x, y, size (diameter, m), coordination (contacts), pressure, deviator "
                 "(half the difference of the principal stresses, of spheres sqrt(3 J_2), Pa), friction (mean "
                 "|F_t|/F_n of the contacts that push), speed, vx, vy (m/s), spin (rad/s).",
             *mobilised =
                 "Mean |F_t|/(mu F_n) of the contacts of every grain that push; of |F_t|/F_n where mu is not "
                 "given; 0 without friction.",
             *ways =
                 "Displacements of grains since the first of these states, m, (n, 2) for each, of spheres (n, 3); "
                 "without the shear of a cell whose strains are given. In a periodic cell grains must not move "
                 "farther than half a cell between two states.";
  m.def("grain_values", &values_of_grains<Packing>, py::arg("packing"), py::arg("name"), values);
  m.def("grain_values", &values_of_grains<PackingIn<3>>, py::arg("packing"), py::arg("name"));
  m.def("mobilisation", &mobilisations_of<Packing>, py::arg("packing"), py::arg("friction") = py::none(), mobilised);
  m.def("mobilisation", &mobilisations_of<PackingIn<3>>, py::arg("packing"), py::arg("friction") = py::none());
  m.def("displacements", &displacements_of<2>, py::arg("packings"), py::arg("shear_strain") = std::vector<double>{},
        ways);
  m.def("displacements", &displacements_of<3>, py::arg("packings"), py::arg("shear_strain") = std::vector<double>{});
  m.def("_at_time", &fields::at_time, py::arg("time"), py::arg("values"), py::arg("t"),
        "Values at a time between two rows, straight from one to the next; those of the first and last row beyond.");
  m.def(
      "_rotations",
      [](const std::vector<const Packing*>& packings) {
        py::list list;
        for (auto& turned : texture::rotations(packings)) list.append(taken_over(std::move(turned)));
        return list;
      },
      py::arg("packings"), "Rotations of grains since the first of these states, rad, an array for each.");
}

void bind_force_scales(py::module_& m) {
  const char* scale = "(mean, tension), N: forces above the one are strong, those below the other pull.";
  m.def("_mean_push", &texture::mean_push<2>, py::arg("states"),
        "Mean force of the contacts that push, of several states together, N.");
  m.def(
      "_mean_push",
      [](const std::vector<const PackingIn<3>*>& states) {
        return texture::mean_push(
            mapped(states, [](const PackingIn<3>* p) -> const ContactsIn<3>* { return &p->contacts; }));
      },
      py::arg("states"));
  m.def(
      "_force_scale",
      [](const StageResult& stage, const Snapshot& state) {
        return scale_of(
            [&] { return figures::force_scale(state.packing, figures::state_numbers(stage, state, false)); });
      },
      py::arg("stage"), py::arg("state"), scale);
  m.def(
      "_force_scale",
      [](const SphereResult& stage, const SnapshotIn<3>& state) {
        return scale_of([&] { return figures::force_scale(stage, state); });
      },
      py::arg("stage"), py::arg("state"), scale);
  m.def(
      "_force_scale", [](const FilmResult& film) { return scale_of([&] { return figures::force_scale(film); }); },
      py::arg("film"), scale);
  m.def(
      "_force_scale",
      [](const Packing& packing, double mean, const std::vector<std::uint8_t>& doubtful) {
        return scale_of([&] { return texture::force_scale(packing.contacts, mean, doubtful); });
      },
      py::arg("packing"), py::arg("mean") = statistics::unknown, py::arg("doubtful") = std::vector<std::uint8_t>{},
      scale);
}

}  // namespace

void bind_pictures(py::module_& m) {
  bind_colourings(m);
  bind_maps_of_films(m);
  bind_numbers_of_grains(m);
  bind_force_scales(m);
}

}  // namespace arenite::python
