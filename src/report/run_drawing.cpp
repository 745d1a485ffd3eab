#include "report/run_drawing.hpp"

#include <fstream>
#include <iterator>

#include "io/run_folder.hpp"
#include "ledger/virtual_film.hpp"
#include "report/field_drawing.hpp"
#include "report/run_density.hpp"
#include "report/sample_drawing.hpp"
#include "report/study_figures.hpp"
#include "study/final_state.hpp"
#include "study/run_field.hpp"

namespace arenite::report {

namespace fs = std::filesystem;

std::string run_drawing(const fs::path& run, const Figure& figure) {
  const std::string load = figure.stage.empty() ? "*" : figure.stage;
  switch (figure.kind) {
    case FigureKind::film: return film_drawing(ledger::film_json(run));
    case FigureKind::phases: return phases_drawing(study::field_of(run));
    case FigureKind::zoom: return zoom_drawing(study::field_of(run, load));
    case FigureKind::cracks: return cracks_drawing(study::field_of(run, load));
    default: return sample_drawing(study::final_state(run, false, figure.stage), figure.kind);
  }
}

std::string RunNumbers::with(const fs::path& run, const std::string& path) {
  if (is_of_film(path)) return ledger::has_film(run) ? "{\"film\":" + ledger::film_json(run) + "}" : "";
  std::ifstream in(run / "numbers.json", std::ios::binary);
  std::string numbers(std::istreambuf_iterator<char>(in), {});
  if (path.empty() || has_numbers(numbers, path) || io::stage_files(run).empty()) return numbers;
  const auto at = curves_.find(run);
  return at != curves_.end() ? at->second : curves_[run] = study::curves_json(study::final_state(run));
}

}  // namespace arenite::report
