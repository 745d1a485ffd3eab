#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "report/run_density.hpp"
#include "report/sample_drawing.hpp"
#include "report/study_page.hpp"
#include "study_parts.hpp"

namespace arenite::app {

namespace fs = std::filesystem;

namespace {

/// Numbers as runs keep them, and where these leave curves out, those of the last state, which is measured again.
struct RunNumbers {
  const study::StudyFolder& folder;
  std::map<std::string, std::string> curves = {};

  std::string with(const std::string& run, const std::string& path) {
    std::ifstream in(folder.numbers(run), std::ios::binary);
    std::string numbers(std::istreambuf_iterator<char>(in), {});
    if (path.empty() || report::has_numbers(numbers, path) || io::stage_files(folder.run(run)).empty()) return numbers;
    const auto at = curves.find(run);
    return at != curves.end() ? at->second : curves[run] = study::curves_json(study::final_state(folder.run(run)));
  }
};

}  // namespace

fs::path figures_of(const study::Study& study) { return fs::path(study.file).parent_path() / "figures.toml"; }

fs::path write_study_figures(const study::Study& study, const study::StudyFolder& folder) {
  const fs::path declared = figures_of(study);
  std::ifstream in(declared, std::ios::binary);
  if (!in) throw InputError(declared.string(), 0, "cannot be read; it declares the figures of the study, one [[figures]] each (docs/studies.md)");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  RunNumbers numbers{folder};
  report::StudyPage page{study.title, report::read_figures(text, declared.string()), study::collect(study, folder),
                         [&](const std::string& run, const std::string& path) { return numbers.with(run, path); },
                         [&](const std::string& run, bool forces) { return report::sample_drawing(study::final_state(folder.run(run)), forces); }};
  const fs::path file = folder.out / "study.html";
  report::write_study_page(file, page);
  return file;
}

}  // namespace arenite::app
