#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "campaign/collect.hpp"
#include "report/figure_list.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// One curve of a figure. Points have standard errors, or what the figure asks for, where several runs make one, NaN
/// otherwise.
struct FigureCurve {
  std::string name = {};
  statistics::Curve points = {};
  std::size_t group = 0, part = 0;      ///< which value of `by`, which of `y` or `curves`
  bool film = false;                    ///< what a film gives
  bool fit = false;                     ///< an exponential through the curve before it
  bool beside = false, source = false;  ///< of `Figure::beside`, of `Figure::source_points`
  std::size_t fewest = 0, most = 0;     ///< runs that make a point
};

/// The numbers of a run, by its name and with what stands at a path of a figure if there is such; empty if it has none.
using NumbersOf = std::function<Numbers(const std::string& run, const std::string& path, const Figure& figure)>;

/// Curves of a figure from the runs of a study that are done: means over runs that differ in their seed alone, in the
/// order of `by`. Densities are means over all runs of a curve; `numbers` is asked for those only. Throws InputError
/// for a key that is not swept.
std::vector<FigureCurve> curves_of(const Figure& figure, const campaign::CollectedTable& table,
                                   const NumbersOf& numbers);

/// Whether a path to numbers says what a film gives.
inline bool is_of_film(const std::string& path) { return path.starts_with("film."); }
/// The runs of which figures want a film: all that those of kind `film` want.
std::vector<std::string> filmed_runs(const std::vector<Figure>& figures, const campaign::CollectedTable& table);

/// The first run that a figure wants, which is drawn where it shows one; empty if none is done.
std::string run_of(const Figure& figure, const campaign::CollectedTable& table);

}  // namespace arenite::report
