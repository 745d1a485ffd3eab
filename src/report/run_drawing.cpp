#include "report/run_drawing.hpp"

#include "io/read_file.hpp"
#include "io/run_folder.hpp"
#include "campaign/virtual_film.hpp"
#include "report/field_drawing.hpp"
#include "report/run_density.hpp"
#include "report/sample_drawing.hpp"
#include "report/study_figures.hpp"
#include "statistics/numbers.hpp"
#include "workflow/final_state.hpp"
#include "workflow/run_field.hpp"

namespace arenite::report {

namespace fs = std::filesystem;

namespace {

/// Solid fractions of windows with this share of the box's area, against the numbers of their places.
Numbers windows_of(const fs::path& run, double share) {
  constexpr int places = 50;
  Numbers place = Numbers::list();
  for (int k = 1; k <= places; ++k) place.push_back(k);
  const auto fractions = texture::window_fractions(study::final_state(run).packing, share, places);
  return Numbers{{"window", {{"place", place}, {"solid_fraction", fractions}}}};
}

}  // namespace

Numbers run_drawing(const fs::path& run, const Figure& figure) {
  const std::string load = figure.stage.empty() ? "*" : figure.stage;
  switch (figure.kind) {
    case FigureKind::film: return film_drawing(study::film_numbers(run));
    case FigureKind::phases: return phases_drawing(study::field_of(run));
    case FigureKind::zoom: return zoom_drawing(study::field_of(run, load));
    case FigureKind::cracks: return cracks_drawing(study::field_of(run, load));
    default: return sample_drawing(study::final_state(run, false, figure.stage), figure.kind);
  }
}

Numbers RunNumbers::with(const fs::path& run, const std::string& path, const Figure& figure) {
  if (is_of_film(path)) return study::has_film(run) ? Numbers{{"film", study::film_numbers(run)}} : Numbers{};
  if (path.starts_with("window.")) return io::stage_files(run).empty() ? Numbers{} : windows_of(run, figure.window.value_or(1));
  const fs::path file = run / "numbers.json";
  Numbers numbers = fs::exists(file) ? from_json(io::read_file(file)).value_or(Numbers{}) : Numbers{};
  if (path.empty() || has_numbers(numbers, path) || io::stage_files(run).empty()) return numbers;
  const auto sectors = static_cast<int>(figure.sectors.value_or(texture::Options{}.sectors));
  const auto [at, is_new] = curves_.try_emplace({run, sectors});
  if (is_new) at->second = study::curves_of(study::final_state(run, false, "", sectors));
  return at->second;
}

}  // namespace arenite::report
