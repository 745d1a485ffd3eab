#include "campaign/dropped_fields.hpp"

#include <algorithm>

namespace arenite::study {

DroppedFields::DroppedFields(const Study& study, const StudyFolder& folder, const Store& store) : folder_(folder), store_(store) {
  for (const StudyRun& run : study.runs)
    for (const PlannedStage& stage : run.stages)
      if (stage.field) users_[stage.hash].push_back(run.name);
}

void DroppedFields::run_settled(const StudyRun& run) const {
  const auto is_settled = [&](const std::string& name) {
    const auto status = read_status(folder_, name);
    return status && status->settled();
  };
  for (const PlannedStage& stage : run.stages) {
    if (!stage.field) continue;
    std::error_code error;
    for (const auto& file : {stage.file, stage.former})
      if (!file.empty()) std::filesystem::remove(folder_.run(run.name) / file, error);
    const auto& users = users_.at(stage.hash);
    if (std::all_of(users.begin(), users.end(), is_settled)) store_.drop(stage.hash);
  }
}

}  // namespace arenite::study
