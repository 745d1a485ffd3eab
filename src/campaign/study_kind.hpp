#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace arenite::campaign {

/// What the runs of a study are alike in, by the last stage of their recipes.
struct StudyKind {
  std::vector<std::filesystem::path> driven;  ///< folders of runs that all strain their sample at a rate; two at least
  std::string
      flow;  ///< "beverloo": three runs or more that discharge; "runout": a side is opened; "janssen": the floor
             ///< sinks; "critical-state": a cell is sheared, under several frictions; empty: none of these

  /// Ids of the figures over runs that suit them.
  std::vector<std::string> figures() const;
};

/// Of a study's folder, or a file in it; of none where there are no runs, or runs of films. Throws InputError for a
/// recipe of a run that cannot be read.
StudyKind kind_of_study(const std::filesystem::path& study);

}  // namespace arenite::campaign
