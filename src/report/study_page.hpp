#pragma once
#include <filesystem>
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

/// What a figure's bars, bands or ticks are and over how many samples, as a sentence: "Bars: standard error over 5
/// samples"; what is of one sample is said to be. Empty where there is nothing to say.
std::string spread_text(const Figure& figure, const std::vector<FigureCurve>& curves);

/// What the page of a study says.
struct StudyPage {
  std::string title;
  std::vector<Figure> figures;
  campaign::CollectedTable table;
  NumbersOf numbers;
  /// What a figure shows of one run, run_drawing; may throw InputError, whose sentence the figure then says.
  std::function<Numbers(const std::string& run, const Figure& figure)> drawing = {};
  std::function<std::string(const std::string& run)> link =
      {};  ///< to the page of a run from that of the study; empty where there is none
};

/// Writes one HTML file without references to others, all figures with their curves, error bars and what the source
/// says, and beside it as numbers (study.hdf5 of study.html) the title and the figures, from which these are drawn for
/// print.
void write_study_page(const std::filesystem::path& path, const StudyPage& page);

/// {"title", "figures"} as they are on a page; not known where they do not lie beside it. Throws InputError for what is
/// damaged.
Numbers figures_on(const std::filesystem::path& page);

/// What stands at an axis for a swept key or a number: its name with its unit, or as much as its statistic says of it
/// up to the first comma.
std::string label_of(const campaign::CollectedTable& table, const std::string& name);

/// What the page of a study without figures.toml shows: each main number against the swept key with the most values
/// that are numbers, a curve for each value of the next one; none where no key but the seed has two numbers.
std::vector<Figure> default_figures(const campaign::CollectedTable& table);

/// The runs as the page lists them: keys, main numbers, and a row a run with its values, numbers and a link to its page
/// (empty: none).
Numbers runs_table(const campaign::CollectedTable& table,
                   const std::function<std::string(const std::string& run)>& link);

}  // namespace arenite::report
