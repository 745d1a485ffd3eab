#include "statistics/json.hpp"

#include <cmath>

namespace arenite::statistics {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

Json matrix(const Tensor2& t) { return {{number(t.xx), number(t.xy)}, {number(t.yx), number(t.yy)}}; }

void put(Json& to, const std::string& name, const Estimate& e) {
  if (std::isfinite(e.value)) to[name] = Json{{"value", e.value}, {"error", number(e.error)}};
}
void put(Json& to, const std::string& name, double value) {
  if (std::isfinite(value)) to[name] = value;
}
void put(Json& to, const std::string& name, const TensorEstimate& t) {
  if (std::isfinite(t.value.xx)) to[name] = Json{{"value", matrix(t.value)}, {"error", matrix(t.error)}};
}
void put(Json& to, const std::string& name, const Tensor2& t) {
  if (std::isfinite(t.xx)) to[name] = matrix(t);
}
void put(Json& to, const std::string& name, const ByName<Estimate>& values) {
  Json group = Json::object();
  for (const auto& [key, value] : values) put(group, key, value);
  if (!group.empty()) to[name] = group;
}

Json curve(const Curve& c) { return {{"x", numbers(c.x)}, {"y", numbers(c.y)}, {"error", numbers(c.error)}}; }

}  // namespace arenite::statistics
