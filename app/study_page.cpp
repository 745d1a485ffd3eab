#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "report/run_drawing.hpp"
#include "report/study_page.hpp"
#include "study_parts.hpp"

namespace arenite::app {

namespace fs = std::filesystem;

fs::path figures_of(const study::Study& study) { return fs::path(study.file).parent_path() / "figures.toml"; }

std::vector<report::Figure> read_study_figures(const study::Study& study) {
  const fs::path declared = figures_of(study);
  std::ifstream in(declared, std::ios::binary);
  if (!in) throw InputError(declared.string(), 0, "cannot be read; it declares the figures of the study, one [[figures]] each (docs/studies.md)");
  return report::read_figures({std::istreambuf_iterator<char>(in), {}}, declared.string());
}

fs::path write_study_figures(const study::Study& study, const study::StudyFolder& folder) {
  report::RunNumbers numbers;
  report::StudyPage page{study.title, read_study_figures(study), study::collect(study, folder),
                         [&](const std::string& run, const std::string& path, const report::Figure& figure) { return numbers.with(folder.run(run), path, figure); },
                         [&](const std::string& run, const report::Figure& figure) { return report::run_drawing(folder.run(run), figure); }};
  const fs::path file = folder.out / "study.html";
  report::write_study_page(file, page);
  return file;
}

}  // namespace arenite::app
