#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "report/colour_ends.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/page_document.hpp"
#include "report/print/animation.hpp"
#include "thermal/inference/film_fit.hpp"
#include "thermal/inference/film_maps.hpp"
#include "thermal/inference/force_certainty.hpp"

/// What pictures are drawn from.
namespace arenite::python {
namespace {

namespace figures = report::figures;

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
  py::dict ends;
  for (const auto& layer : fields::coarse_layers<D>()) {
    if (!fields::has_layer(layer, f)) continue;
    auto values = fields::values_of(layer, f);
    ends[py::str(layer.name)] = report::ends_of(layer, f, values);
    d[py::str(layer.name)] = taken_over(std::move(values), shape);
  }
  d["ends"] = ends;
  return d;
}

/// Layers of the plane or of space.
template <int D> void bind_layers_of(py::module_& m, const char* layers) {
  m.def(
      layers, [] { return to_python(report::named_kinds(fields::coarse_layers<D>())); },
      "{name: [label, symbol, unit, formula, scale of colours]} of pictures of coarse-grained fields.");
  m.def("_layers_of_state", &layers_of<D>, py::arg("stage"), py::arg("state"),
        "Coarse-grained fields of a state by their names, (layers,) rows from below, x, y (, z) of their places, and "
        "the \"ends\" of their colours.");
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
  m.def(
      "_ends_of",
      [](std::vector<double> values, double share) {
        Call call;
        return call.without_lock([&] { return report::ends_of(std::move(values), share); });
      },
      py::arg("values"), py::arg("share"), "Beyond which this share of the values lies, of those that are known.");
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
            one["ends"] = report::ends_of({values.begin(), values.end()}, report::pixels_beyond);
            one["values"] = taken_over(std::move(values), {film->film.height, film->film.width});
          }
          all[py::str(std::string(map.id))] = one;
        }
        return all;
      },
      py::arg("film") = py::none(),
      "{name: {label, title, unit, around, cyclic, marks, ends, values}} of the maps that a film has, in the order of "
      "its "
      "page; without a film what is said of all.");
  m.def(
      "_doubtful_contacts", [](const FilmResult& film) { return taken_over(inference::doubtful_contacts(film)); },
      py::arg("film"), "1 for each contact that counts as there, and by its force and its gap may not be.");
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
  bind_force_scales(m);
}

}  // namespace arenite::python
