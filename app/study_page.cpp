#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "report/study_page.hpp"
#include "study_parts.hpp"

namespace arenite::app {

namespace fs = std::filesystem;

fs::path figures_of(const study::Study& study) { return fs::path(study.file).parent_path() / "figures.toml"; }

fs::path write_study_figures(const study::Study& study, const study::StudyFolder& folder) {
  const fs::path declared = figures_of(study);
  std::ifstream in(declared, std::ios::binary);
  if (!in) throw InputError(declared.string(), 0, "cannot be read; it declares the figures of the study, one [[figures]] each (docs/studies.md)");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  report::StudyPage page{study.title, report::read_figures(text, declared.string()), study::collect(study, folder), [&](const std::string& run) {
                           std::ifstream numbers(folder.numbers(run), std::ios::binary);
                           return std::string(std::istreambuf_iterator<char>(numbers), {});
                         }};
  const fs::path file = folder.out / "study.html";
  report::write_study_page(file, page);
  return file;
}

}  // namespace arenite::app
