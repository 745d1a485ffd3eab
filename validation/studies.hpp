#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "campaign/study.hpp"

namespace arenite::validation {

/// A study that comes with the program (validation/studies/NAME); one without recipe.toml is tables alone.
struct StudySource {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  ///< name and text: recipe.toml, tables, figures.toml
  bool has_runs() const;
  std::vector<std::string> small = {};  ///< KEY=VALUE, as for --set, that make the small version
  double seconds_a_run = 10;            ///< of one core, about; which of several studies is cheaper follows from it
};

/// All of them, by name.
const std::vector<StudySource>& studies();
/// nullptr if there is none of that name.
const StudySource* find_study(const std::string& name);

/// Text of a file of validation/studies/NAME; empty if there is none.
std::string embedded_text(const std::string& study, const std::string& file);

/// Puts the files of a study into `folder`, and the recipe that its own is laid over beside it. Files that are the same
/// already are left alone.
void unpack(const StudySource& source, const std::filesystem::path& folder);
/// The same, and reads the study from there.
campaign::Study unpack_study(const StudySource& source, const std::filesystem::path& folder, bool small,
                             const std::vector<std::string>& overrides = {});

/// What cmake/embed_studies.cmake makes of studies/: study, file and text, in order of the names.
struct EmbeddedFile {
  const char *study, *file, *text;
};
const std::vector<EmbeddedFile>& embedded_files();

}  // namespace arenite::validation
