#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/result.hpp"

namespace arenite::report {

/// A result in a few numbers: what made it, how every stage ended, and the last state with its walls, equilibrium,
/// energies and texture. The JSON's texture is the one stored with the result, or measured now if none is.
class Summary {
 public:
  /// Reads a stage file or the stage files of a run's folder. Throws InputError for anything else.
  explicit Summary(const std::filesystem::path& result);

  std::string text() const;   ///< for people
  std::string json() const;   ///< for programs: the texture's fields with "provenance" and "stages" beside them

 private:
  struct Stage {
    std::string file;
    StageResult result;       ///< with its last frame only
    std::size_t states = 0;
  };
  std::vector<Stage> stages_;
};

}  // namespace arenite::report
