#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/collect.hpp"
#include "report/figure_list.hpp"
#include "report/study/study_figures.hpp"
#include "report/study/study_tests.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

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
      {};                 ///< to the page of a run from that of the study; empty where there is none
  StudyTests tests = {};  ///< whose figures stand first
};

/// Writes one HTML file without references to others, all figures with their curves, error bars and what the source
/// says, and beside it as numbers (study.hdf5 of study.html) the title and the figures, from which these are drawn for
/// print.
void write_study_page(const std::filesystem::path& path, const StudyPage& page);

/// The page of such a document: {"title", "runs", "made", "figures"}, "table" (runs_table), and tables of texts,
/// "first" and "tables" ({"title", "heads", "rows"}), before and after the figures; with what all pages say (notation,
/// drawn).
std::string html_of(Numbers document);

/// {"title", "figures"} as they are on a page; not known where they do not lie beside it. Throws InputError for what is
/// damaged.
Numbers figures_on(const std::filesystem::path& page);

}  // namespace arenite::report
