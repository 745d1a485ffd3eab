#include <unordered_map>
#include <unordered_set>

#include "campaign/run_study.hpp"
#include "workflow/store.hpp"

namespace arenite::study {

std::vector<std::size_t> shard_of(const Study& study, std::size_t shard, std::size_t shards) {
  std::unordered_map<std::string, std::size_t> group_of;  // by packing
  std::vector<std::vector<std::size_t>> groups;
  std::unordered_set<std::string> seen;
  for (std::size_t r = 0; r < study.runs.size(); ++r) {
    if (!seen.insert(study.runs[r].name).second) continue;
    const auto [at, is_new] = group_of.emplace(study.runs[r].stages.front().hash, groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(r);
  }
  std::vector<std::size_t> part;
  std::size_t place = 0;
  for (const auto& group : groups)
    for (const std::size_t run : group)
      if (place++ * shards / seen.size() == shard) part.push_back(run);
  return part;
}

double seconds_of_missing(const Study& study, const std::vector<std::size_t>& runs, const StudyFolder& folder) {
  const StoreAccount account = read_account(folder.store);
  std::unordered_set<std::string> counted;
  std::error_code error;
  double seconds = 0;
  for (const std::size_t run : runs)
    for (const PlannedStage& stage : study.runs[run].stages) {
      if (!counted.insert(stage.hash).second || std::filesystem::exists(stored_file(folder.store, stage.hash), error)) continue;
      const auto mean = account.by_name.find(stage.name);
      seconds += mean == account.by_name.end() ? std::numeric_limits<double>::quiet_NaN() : mean->second.sum / static_cast<double>(mean->second.count);
    }
  return seconds;
}

}  // namespace arenite::study
