#include "report/sample_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace arenite::report {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, double step) { return std::isfinite(value) ? std::round(value / step) * step : 0; }
double in_mm(double metres) { return rounded(1e3 * metres, 0.01); }

Json contacts_json(const Contacts& contacts) {
  double sum = 0, count = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c) && contacts.fn[c] > 0) sum += contacts.fn[c], ++count;
  Json i = Json::array(), j = Json::array(), f = Json::array();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c)) continue;
    i.push_back(contacts.i[c]);
    j.push_back(contacts.j[c]);
    f.push_back(rounded(contacts.fn[c] * count / sum, 0.01));
  }
  return {{"i", i}, {"j", j}, {"f", f}};
}

}  // namespace

std::string sample_drawing(const study::FinalState& state, bool forces) {
  const Grains& grains = state.packing.grains;
  double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    left = std::min(left, grains.x[g] - grains.radius[g]);
    right = std::max(right, grains.x[g] + grains.radius[g]);
    bottom = std::min(bottom, grains.y[g] - grains.radius[g]);
    top = std::max(top, grains.y[g] + grains.radius[g]);
  }
  Json j{{"size", {in_mm(right - left), in_mm(top - bottom)}}};
  for (const char* name : {"x", "y", "r", "material", "glued"}) j[name] = Json::array();
  for (std::size_t g = 0; g < grains.size(); ++g) {
    j["x"].push_back(in_mm(grains.x[g] - left));
    j["y"].push_back(in_mm(grains.y[g] - bottom));
    j["r"].push_back(in_mm(grains.radius[g]));
    j["material"].push_back(grains.material[g]);
    j["glued"].push_back(g < grains.zone.size() && grains.zone[g] != 0 ? 1 : 0);
  }
  if (forces) {
    j.update(contacts_json(state.packing.contacts));
  } else {
    j["stress"] = Json::array();
    for (const double s : state.texture.per_grain.sigma_norm) j["stress"].push_back(rounded(s, 0.01));
  }
  return j.dump();
}

}  // namespace arenite::report
