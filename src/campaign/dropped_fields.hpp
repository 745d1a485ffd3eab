#pragma once
#include <string>
#include <unordered_map>
#include <vector>

#include "workflow/store.hpp"
#include "campaign/study_folder.hpp"

namespace arenite::study {

/// Takes field files (cemented samples and loads) away once their numbers are kept: a run's own when it is settled, those of the
/// store when all runs of the study that share them are.
class DroppedFields {
 public:
  DroppedFields(const Study& study, const StudyFolder& folder, const Store& store);
  void run_settled(const StudyRun& run) const;

 private:
  const StudyFolder& folder_;
  const Store& store_;
  std::unordered_map<std::string, std::vector<std::string>> users_;  ///< names of runs, by hash of the stage
};

}  // namespace arenite::study
