#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "report/figure_list.hpp"

namespace arenite::report {

/// What a figure shows of one run, from the files in its folder, as JSON: sample_drawing, film_drawing, phases_drawing,
/// zoom_drawing or cracks_drawing by the figure's kind. Throws InputError where the run does not have it.
std::string run_drawing(const std::filesystem::path& run, const Figure& figure);

/// The numbers of a run as figures read them: numbers.json; for paths that begin with "film." what is kept of its film, as
/// "film"; and for other paths that are not in numbers.json the texture of its last state with all curves, measured again.
class RunNumbers {
 public:
  std::string with(const std::filesystem::path& run, const std::string& path);

 private:
  std::map<std::filesystem::path, std::string> curves_;
};

}  // namespace arenite::report
