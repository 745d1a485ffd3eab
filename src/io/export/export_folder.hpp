#pragma once
#include <filesystem>
#include <vector>

#include "io/export/export.hpp"

namespace arenite::io {

/// Collects files and writes each when it cannot grow any more. Unless it gets to its end, what it wrote goes again:
/// half of a loading looks like a whole one. Throws InputError for a folder that cannot be made.
class ExportFolder {
 public:
  explicit ExportFolder(std::filesystem::path folder);
  ExportFolder(const ExportFolder&) = delete;
  ExportFolder& operator=(const ExportFolder&) = delete;
  ~ExportFolder();

  /// Files of one snapshot: those of the snapshot before that are not among them are complete.
  void add(std::vector<NamedBytes> files);

  /// A file that does not grow.
  void write(const NamedBytes& file);

  /// All that was written.
  std::vector<std::filesystem::path> finish();

 private:
  std::filesystem::path folder_;
  bool made_ = false, finished_ = false;
  std::vector<NamedBytes> growing_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace arenite::io
