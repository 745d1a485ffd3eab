#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "report/figure_list.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What a figure shows of one run, from the files in its folder, as JSON: sample_drawing, film_drawing, phases_drawing,
/// zoom_drawing or cracks_drawing by the figure's kind. Throws InputError where the run does not have it.
Numbers run_drawing(const std::filesystem::path& run, const Figure& figure);

/// The numbers of a run as figures read them: numbers.json; for paths that begin with "film." what is kept of its film, as
/// "film"; for those that begin with "window." the solid fraction of windows of `Figure::window` at 50 random places, as "window"
/// with {"place", "solid_fraction"}; and for other paths that are not in numbers.json the texture of its last state with all
/// curves, measured again with directions in `Figure::sectors`.
class RunNumbers {
 public:
  Numbers with(const std::filesystem::path& run, const std::string& path, const Figure& figure);

 private:
  std::map<std::pair<std::filesystem::path, int>, Numbers> curves_;  ///< by the number of sectors
};

}  // namespace arenite::report
