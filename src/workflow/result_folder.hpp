#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace arenite::study {

/// Creates a folder and those above it; refuses with the system's reason.
void make_folder(const std::filesystem::path& folder);

/// A run's folder: result files of this recipe on top, those of other versions of it under earlier/, from where they
/// come back when they are wanted again.
class ResultFolder {
 public:
  /// `former` (empty, or one for each name) are names that the same files had in folders of before.
  ResultFolder(std::filesystem::path out, const std::vector<std::string>& names, const std::vector<std::string>& former = {});
  std::filesystem::path operator/(const std::string& name) const { return out_ / name; }
  /// What was put aside now, and which exports in the folder show it still; empty if nothing was.
  std::string what_was_put_aside() const;

 private:
  void put_aside(const std::filesystem::path& path);
  std::filesystem::path out_;
  std::vector<std::string> put_aside_;
};

}  // namespace arenite::study
