#include "statistics/put_numbers.hpp"

#include <cmath>

namespace arenite::statistics {

Numbers number(double value) { return std::isfinite(value) ? Numbers(value) : Numbers(nullptr); }

Numbers numbers(const std::vector<double>& values) {
  Numbers list = Numbers::list();
  for (const double v : values) list.push_back(number(v));
  return list;
}

Numbers matrix(const Tensor2& t) { return {{number(t.xx), number(t.xy)}, {number(t.yx), number(t.yy)}}; }

void put(Numbers& to, const std::string& name, const Estimate& e) {
  if (std::isfinite(e.value)) to[name] = Numbers{{"value", e.value}, {"error", number(e.error)}};
}
void put(Numbers& to, const std::string& name, double value) {
  if (std::isfinite(value)) to[name] = value;
}
void put(Numbers& to, const std::string& name, const TensorEstimate& t) {
  if (std::isfinite(t.value.xx)) to[name] = Numbers{{"value", matrix(t.value)}, {"error", matrix(t.error)}};
}
void put(Numbers& to, const std::string& name, const Tensor2& t) {
  if (std::isfinite(t.xx)) to[name] = matrix(t);
}
void put(Numbers& to, const std::string& name, const ByName<Estimate>& values) {
  Numbers group = Numbers::tree();
  for (const auto& [key, value] : values) put(group, key, value);
  if (!group.empty()) to[name] = group;
}

Numbers curve(const Curve& c) { return {{"x", numbers(c.x)}, {"y", numbers(c.y)}, {"error", numbers(c.error)}}; }

}  // namespace arenite::statistics
