#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/study_figures.hpp"

namespace arenite::report {

/// What the page of a study says.
struct StudyPage {
  std::string title;
  std::vector<Figure> figures;
  study::CollectedTable table;
  NumbersOf numbers;
  std::function<std::string(const std::string& run, bool forces)> drawing = {};  ///< of a run's last state (sample_drawing)
};

/// One HTML file without references to others: all figures with their curves, error bars and what the source says.
std::string study_page(const StudyPage& page);
void write_study_page(const std::filesystem::path& path, const StudyPage& page);

}  // namespace arenite::report
