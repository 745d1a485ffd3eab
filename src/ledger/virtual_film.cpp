#include "ledger/virtual_film.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "study/film_numbers.hpp"
#include "study/film_road.hpp"
#include "study/film_twin.hpp"
#include "study/named_result.hpp"
#include "study/shoot_film.hpp"

namespace arenite::ledger {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path kept(const Run& run) { return run.folder() / "virtual-film.json"; }

Packing state_of(const Run& run, const std::string& stage) {
  if (auto state = study::last_state(run.folder(), stage)) return std::move(*state);
  throw InputError(run.folder().string(), 0, "there is no stage \"" + stage + "\" of this run; remove its folder and run the study again");
}

/// The swing of the simulated grain that lies nearest to each grain found at the smallest load.
std::vector<double> true_swing(const study::FilmOutcome& film, const Packing& low, const Packing& high) {
  const auto released = study::stress_of_disks(low), loaded = study::stress_of_disks(high);
  const Vec2 corner{low.domain.wall[left].position, low.domain.wall[bottom].position};
  const FilmResult& result = film.result;
  std::vector<double> swing;
  for (std::size_t i = 0; i < result.packing.grains.size(); ++i) {
    const Vec2 found = result.origin + Vec2{result.grains.x[i] * result.pixel, -result.grains.y[i] * result.pixel};
    std::size_t best = 0;
    for (std::size_t j = 1; j < low.grains.size(); ++j)
      if (norm(low.grains.centre(j) - corner - found) < norm(low.grains.centre(best) - corner - found)) best = j;
    swing.push_back(loaded[best] - released[best]);
  }
  return swing;
}

}  // namespace

bool make_film(const Run& run, const std::function<bool()>& asked_to_stop) {
  if (fs::exists(kept(run))) return true;
  const fs::path folder = run.folder() / "film";
  study::ShootOptions shooting;
  shooting.out = folder;
  shooting.progress = [&](double) { return !asked_to_stop(); };
  const auto camera = study::read_film_recipe((run.study->folder() / "camera.toml").string(), {"seed=" + run.text("seed")});
  const auto files = study::shoot_film(camera, run.folder(), shooting);
  if (files.empty()) return false;
  study::FilmRunOptions measuring;
  measuring.out = folder / "result";
  measuring.asked_to_stop = asked_to_stop;
  const auto film = study::run_film(files.front(), study::read_film_recipe(files.back().string(), {}), measuring);
  if (film.interrupted) return false;
  const auto found = study::agreement(film.result.swing.sigma_hyd, true_swing(film, state_of(run, "low"), state_of(run, "high")),
                                      std::vector<std::uint8_t>(film.result.swing.sigma_hyd.size(), 1));
  const Json j{{"grains", found.grains}, {"correlation", found.correlation}, {"rms_sigma_norm", found.rms_sigma_norm}, {"slope", found.slope}};
  io::write_atomically(kept(run), j.dump(1) + "\n");
  fs::remove_all(folder);
  return true;
}

FilmAgreement film_agreement(const Run& run) {
  std::ifstream in(kept(run));
  const Json j = Json::parse(in, nullptr, false);
  if (j.is_discarded() || !j.is_object()) return {};
  const auto number = [&](const char* name) { return j.contains(name) && j[name].is_number() ? j[name].get<double>() : statistics::unknown; };
  return {number("grains"), number("correlation"), number("rms_sigma_norm"), number("slope")};
}

}  // namespace arenite::ledger
