#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "report/figure_list.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::report {

/// One state as JSON for a figure: `size` of the box in mm; `x`, `y`, `r` of the grains in mm from its lower left
/// corner, their `material`, a place in `materials`, and 1 for those that are `glued`; `rims` of grains that are no
/// disks, and `boundaries` with what is seen of them; for FigureKind::forces the
/// contacts between grains `i`, `j` with their normal force `f` over the mean push, for FigureKind::stresses `stress`
/// of the grains over the mean.
Numbers sample_drawing(const workflow::FinalState& state, FigureKind kind);

/// The same of the grains that a film shows, with `stress` as it gives them over their mean; `film` is what is kept of
/// it (campaign/virtual_film.hpp). Throws InputError if that is no film's.
Numbers film_drawing(const Numbers& film);

/// What a figure shows of one run, from the files in its folder, as JSON: sample_drawing, film_drawing, phases_drawing,
/// zoom_drawing or cracks_drawing by the figure's kind. Throws InputError where the run does not have it.
Numbers run_drawing(const std::filesystem::path& run, const Figure& figure);

/// The numbers of a run as figures read them: those that the study keeps; for paths that begin with "film." what is
/// kept of its film, as "film"; for those that begin with "window." the solid fraction of windows of `Figure::window`
/// at 50 random places, as "window" with {"place", "solid_fraction"}; and for other paths that are not among these the
/// texture of its last state with all curves, measured again with directions in `Figure::sectors`.
class RunNumbers {
 public:
  Numbers with(const std::filesystem::path& run, const std::string& path, const Figure& figure);

 private:
  std::map<std::pair<std::filesystem::path, int>, Numbers> curves_;  ///< by the number of sectors
};

}  // namespace arenite::report
