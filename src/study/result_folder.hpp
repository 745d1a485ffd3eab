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
  ResultFolder(std::filesystem::path out, const std::vector<std::string>& names);
  std::filesystem::path operator/(const std::string& name) const { return out_ / name; }

 private:
  void put_aside(const std::filesystem::path& path) const;
  std::filesystem::path out_;
};

}  // namespace arenite::study
