#include "report/sample_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {
namespace {


double hundredth(double value) { return std::isfinite(value) ? std::round(100 * value) / 100 : 0; }
double in_mm(double metres) { return hundredth(1e3 * metres); }

Numbers contacts_json(const Contacts& contacts) {
  double sum = 0, count = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c) && contacts.fn[c] > 0) sum += contacts.fn[c], ++count;
  Numbers i = Numbers::list(), j = Numbers::list(), f = Numbers::list();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c)) continue;
    i.push_back(contacts.i[c]);
    j.push_back(contacts.j[c]);
    f.push_back(hundredth(contacts.fn[c] * count / sum));
  }
  return {{"i", i}, {"j", j}, {"f", f}};
}

/// What is drawn of grains, in metres.
struct Disks {
  std::vector<double> x, y, radius;
  std::vector<std::int32_t> material;
  std::vector<std::uint8_t> zone;
};

Numbers disks_json(const Disks& disks) {
  double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
  for (std::size_t g = 0; g < disks.x.size(); ++g) {
    left = std::min(left, disks.x[g] - disks.radius[g]);
    right = std::max(right, disks.x[g] + disks.radius[g]);
    bottom = std::min(bottom, disks.y[g] - disks.radius[g]);
    top = std::max(top, disks.y[g] + disks.radius[g]);
  }
  Numbers j{{"size", {in_mm(right - left), in_mm(top - bottom)}}};
  for (const char* name : {"x", "y", "r", "material", "glued"}) j[name] = Numbers::list();
  for (std::size_t g = 0; g < disks.x.size(); ++g) {
    j["x"].push_back(in_mm(disks.x[g] - left));
    j["y"].push_back(in_mm(disks.y[g] - bottom));
    j["r"].push_back(in_mm(disks.radius[g]));
    j["material"].push_back(disks.material[g]);
    j["glued"].push_back(g < disks.zone.size() && disks.zone[g] != 0 ? 1 : 0);
  }
  return j;
}

Numbers stress_json(const std::vector<double>& sigma_norm) {
  Numbers stress = Numbers::list();
  for (const double s : sigma_norm) stress.push_back(hundredth(s));
  return stress;
}

}  // namespace

Numbers sample_drawing(const study::FinalState& state, FigureKind kind) {
  const Grains& grains = state.packing.grains;
  Numbers j = disks_json({grains.x, grains.y, grains.radius, grains.material, grains.zone});
  j["materials"] = Numbers::list();
  for (const Material& material : state.packing.materials) j["materials"].push_back(material.name);
  if (kind == FigureKind::forces) j.update(contacts_json(state.packing.contacts));
  if (kind == FigureKind::stresses) j["stress"] = stress_json(state.texture.per_grain.sigma_norm);
  return j;
}

Numbers film_drawing(const Numbers& film) {
  if (!film.contains("found")) throw InputError("what is kept of the film holds no grains; remove virtual-film.json of this run, and make the film again");
  const Numbers& found = film["found"];
  const auto list = [&](const char* name) { return found[name].get<std::vector<double>>(); };
  Numbers j = disks_json({list("x"), list("y"), list("radius"), found["material"].get<std::vector<std::int32_t>>(), found["zone"].get<std::vector<std::uint8_t>>()});
  j["stress"] = stress_json(list("sigma_norm"));
  return j;
}

}  // namespace arenite::report
