#pragma once
#include "campaign/run_study.hpp"
#include "workflow/store.hpp"

namespace arenite::study {

/// Does one run of a study in this process, and writes its numbers, status and journal. Nothing if another process is at it.
/// No exception leaves it: what goes wrong is the run's state. `waiting` says that it was asked to stop.
std::optional<RunState> run_in_study(const Study& study, const StudyRun& run, const StudyFolder& folder, const Store& store,
                                     const io::AppendLog& journal, const StudyOptions& options);

}  // namespace arenite::study
