#include "grains/fields/laboratory/tested_stage.hpp"

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"

namespace arenite::fields {
namespace {

template <int D>
std::size_t last_with_history(const std::vector<const StageResultIn<D>*>& stages,
                              const std::optional<std::string>& name) {
  for (std::size_t k = stages.size(); k-- > 0;)
    if (has_history(*stages[k]) && name.value_or(stages[k]->name) == stages[k]->name) return k;
  if (!name) throw InputError("this result holds no loading stage with a history");
  throw refusal("there is no stage {} with a history; there are {}", *name,
                list_of(mapped(stages, [](const auto* stage) { return stage->name; }), ", "));
}

}  // namespace

template <int D> bool has_history(const StageResultIn<D>& stage) {
  const std::vector<double>* time = stage.history.find("time");
  return time && time->size() > 1 && !stage.snapshots.empty();
}
template bool has_history<2>(const StageResult&);
template bool has_history<3>(const SphereResult&);

std::size_t stage_with_history(const std::vector<const StageResult*>& stages, const std::optional<std::string>& name) {
  return last_with_history(stages, name);
}
std::size_t stage_with_history(const std::vector<const SphereResult*>& stages, const std::optional<std::string>& name) {
  return last_with_history(stages, name);
}

}  // namespace arenite::fields
