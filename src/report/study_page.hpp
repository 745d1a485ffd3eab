#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/study_figures.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What the page of a study says.
struct StudyPage {
  std::string title;
  std::vector<Figure> figures;
  study::CollectedTable table;
  NumbersOf numbers;
  /// What a figure shows of one run, run_drawing; may throw InputError, whose sentence the figure then says.
  std::function<Numbers(const std::string& run, const Figure& figure)> drawing = {};
};

/// One HTML file without references to others: all figures with their curves, error bars and what the source says.
std::string study_page(const StudyPage& page);
void write_study_page(const std::filesystem::path& path, const StudyPage& page);

}  // namespace arenite::report
