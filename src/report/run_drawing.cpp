#include "report/run_drawing.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "campaign/virtual_film.hpp"
#include "core/mapped.hpp"
#include "geometry/rectangle.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/rev.hpp"
#include "io/disk/store_file.hpp"
#include "model/shapes.hpp"
#include "report/field_drawing.hpp"
#include "report/packing_layers.hpp"
#include "report/study/study_figures.hpp"
#include "statistics/estimate.hpp"
#include "statistics/run_means.hpp"

namespace arenite::report {

namespace fs = std::filesystem;

namespace {

double hundredth(double value) { return std::isfinite(value) ? std::round(100 * value) / 100 : 0; }
double in_mm(double metres) { return hundredth(1e3 * metres); }

Numbers contacts_json(const Contacts& contacts) {
  const texture::ForceScale scale = texture::force_scale(contacts, statistics::unknown);
  Numbers i = Numbers::list(), j = Numbers::list(), f = Numbers::list();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c)) continue;
    i.push_back(contacts.i[c]);
    j.push_back(contacts.j[c]);
    f.push_back(hundredth(contacts.fn[c] / scale.mean));
  }
  return {{"i", i}, {"j", j}, {"f", f}, {"tension", scale.mean > 0 ? scale.tension / scale.mean : 0.0}};
}

/// What is drawn of grains, in metres.
struct Disks {
  std::vector<Vec2> centre;
  std::vector<double> radius;
  std::vector<std::int32_t> material;
  std::vector<std::uint8_t> zone;
};

Numbers disks_json(const Disks& disks, const geometry::Rectangle& box) {
  std::vector<std::uint8_t> zone = disks.zone;
  zone.resize(disks.centre.size(), 0);
  return {{"size", {in_mm(box.width()), in_mm(box.height())}},
          {"x", mapped(disks.centre, [&](Vec2 at) { return in_mm(at.x - box.x_min); })},
          {"y", mapped(disks.centre, [&](Vec2 at) { return in_mm(at.y - box.y_min); })},
          {"r", mapped(disks.radius, in_mm)},
          {"material", disks.material},
          {"glued", mapped(zone, [](std::uint8_t z) { return z != 0 ? 1 : 0; })}};
}

/// Points in a picture of a box: {"x", "y"}.
Numbers points_json(const std::vector<Vec2>& points, const geometry::Rectangle& box) {
  return {{"x", mapped(points, [&](Vec2 at) { return in_mm(at.x - box.x_min); })},
          {"y", mapped(points, [&](Vec2 at) { return in_mm(at.y - box.y_min); })}};
}

/// The rims of grains that are no disks, and the boundaries.
void add_outlines(Numbers& to, const Packing& packing, const geometry::Rectangle& box) {
  if (!packing.grains.shapes.empty()) {
    to["rims"] = Numbers::list();
    for (std::size_t g = 0; g < packing.grains.size(); ++g)
      to["rims"].push_back(points_json(outline_of(packing.grains, g, 0.3), box));
  }
  if (packing.domain.boundaries.empty()) return;
  to["boundaries"] = mapped(packing.domain.boundaries, [&](const Boundary& boundary) {
    Numbers one = points_json(boundary.points, box);
    one["closed"] = boundary.closed;
    one["present"] = boundary.present;
    return one;
  });
}

Numbers stress_json(const std::vector<double>& sigma_norm) { return mapped(sigma_norm, hundredth); }

/// Solid fractions of windows with this share of the box's area, against the numbers of their places.
Numbers windows_of(const fs::path& run, double share) {
  constexpr int places = 50;
  std::vector<int> place(places);
  std::iota(place.begin(), place.end(), 1);
  const auto fractions = texture::window_fractions(workflow::final_state(run).packing, share, places);
  return Numbers{{"window", {{"place", place}, {"solid_fraction", fractions}}}};
}

}  // namespace

Numbers sample_drawing(const workflow::FinalState& state, FigureKind kind) {
  const Grains& grains = state.packing.grains;
  const geometry::Rectangle box = state.packing.domain.boundaries.empty()
                                      ? geometry::bounds(grains.position, grains.radius)
                                      : seen_of(state.packing);
  Numbers j = disks_json({grains.position, grains.radius, grains.material, grains.zone}, box);
  add_outlines(j, state.packing, box);
  j["materials"] = mapped(state.packing.materials, &Material::name);
  if (kind == FigureKind::forces) j.update(contacts_json(state.packing.contacts));
  if (kind == FigureKind::stresses) j["stress"] = stress_json(state.texture.per_grain.sigma_norm);
  return j;
}

Numbers film_drawing(const Numbers& film) {
  if (!film.contains("found"))
    throw InputError(
        "the stored results of the film have no grains; remove virtual-film.hdf5 of this run, and make the film again");
  const Numbers& found = film["found"];
  const auto list = [&](const char* name) { return found[name].get<std::vector<double>>(); };
  const std::vector<double> x = list("x"), y = list("y");
  std::vector<Vec2> centre;
  for (std::size_t g = 0; g < x.size(); ++g) centre.push_back({x[g], y[g]});
  const std::vector<double> radius = list("radius");
  Numbers j = disks_json({centre, radius, found["material"].get<std::vector<std::int32_t>>(),
                          found["zone"].get<std::vector<std::uint8_t>>()},
                         geometry::bounds(centre, radius));
  j["stress"] = stress_json(list("sigma_norm"));
  return j;
}

Numbers run_drawing(const fs::path& run, const Figure& figure) {
  const std::string load = figure.stage.empty() ? "*" : figure.stage;
  switch (figure.kind) {
    case FigureKind::film: return film_drawing(campaign::film_numbers(run));
    case FigureKind::phases: return phases_drawing(workflow::field_of(run));
    case FigureKind::zoom: return zoom_drawing(workflow::field_of(run, load));
    case FigureKind::cracks: return cracks_drawing(workflow::field_of(run, load));
    default: return sample_drawing(workflow::final_state(run, {.stage = figure.stage}), figure.kind);
  }
}

Numbers RunNumbers::with(const fs::path& run, const std::string& path, const Figure& figure) {
  if (is_of_film(path)) return campaign::has_film(run) ? Numbers{{"film", campaign::film_numbers(run)}} : Numbers{};
  if (path.starts_with("window."))
    return io::stage_files(run).empty() ? Numbers{} : windows_of(run, figure.window.value_or(1));
  Numbers numbers = campaign::numbers_of(run);
  if (path.empty() || statistics::has_numbers(numbers, path) || io::stage_files(run).empty()) return numbers;
  const auto sectors = static_cast<int>(figure.sectors.value_or(texture::Options{}.sectors));
  const auto [at, is_new] = curves_.try_emplace({run, sectors});
  if (is_new) at->second = workflow::numbers(workflow::final_state(run, {.sectors = sectors}), true);
  return at->second;
}

}  // namespace arenite::report
