#include <cmath>

#include "core/units.hpp"
#include "identify/findings.hpp"
#include "statistics/json.hpp"

namespace arenite::identify {
namespace {

using statistics::Json;
using statistics::number;

Json to_json(const Finding& f) {
  const auto interval = statistics::confidence_95(f.value);
  Json j{{"value", number(f.value.value)}, {"error", number(f.value.error)}, {"confidence_95", {number(interval.low), number(interval.high)}}};
  j["unit"] = f.unit.empty() ? "1" : si_unit(parse_unit(f.unit).dimension);
  if (std::isfinite(f.value.freedom)) j["degrees_of_freedom"] = f.value.freedom;
  if (f.stated) j["stated"] = {{"value", f.stated->value}, {"agrees", agrees(f)}};
  return j;
}

void put(Json& to, const std::vector<Finding>& findings) {
  for (const auto& f : findings) to[f.name] = to_json(f);
}

Json to_json(const Group& group) {
  Json j{{"name", group.name}, {"count", group.count}};
  put(j, group.findings);
  for (const auto& test : group.tests) {
    Json item{{"name", test.name}};
    put(item, test.findings);
    j["tests"].push_back(item);
  }
  return j;
}

}  // namespace

std::string to_json(const Identification& i) {
  Json j{{"kind", i.kind}, {"file", i.file}, {"groups", Json::array()}};
  for (const auto& group : i.groups) j["groups"].push_back(to_json(group));
  if (i.all) j["all"] = to_json(*i.all);
  j["notes"] = i.notes;
  return j.dump(1);
}

}  // namespace arenite::identify
