#include <cmath>

#include "core/units.hpp"
#include "thermal/identify/findings.hpp"
#include "statistics/put_numbers.hpp"

namespace arenite::identify {
namespace {

using statistics::number;

Numbers numbers(const Finding& f) {
  const auto interval = statistics::confidence_95(f.value);
  Numbers j{{"value", number(f.value.value)}, {"error", number(f.value.error)}, {"confidence_95", {number(interval.low), number(interval.high)}}};
  j["unit"] = f.unit.empty() ? "1" : si_unit(parse_unit(f.unit).dimension);
  if (std::isfinite(f.value.freedom)) j["degrees_of_freedom"] = f.value.freedom;
  if (f.stated) j["stated"] = {{"value", f.stated->value}, {"agrees", agrees(f)}};
  return j;
}

void put(Numbers& to, const std::vector<Finding>& findings) {
  for (const auto& f : findings) to[f.name] = numbers(f);
}

Numbers numbers(const Group& group) {
  Numbers j{{"name", group.name}, {"count", group.count}};
  put(j, group.findings);
  for (const auto& test : group.tests) {
    Numbers item{{"name", test.name}};
    put(item, test.findings);
    j["tests"].push_back(item);
  }
  return j;
}

}  // namespace

Numbers numbers(const Identification& i) {
  Numbers j{{"kind", i.kind}, {"file", i.file}, {"groups", Numbers::list()}};
  for (const auto& group : i.groups) j["groups"].push_back(numbers(group));
  if (i.all) j["all"] = numbers(*i.all);
  j["notes"] = i.notes;
  return j;
}

}  // namespace arenite::identify
