#include "study/film_road.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/version.hpp"
#include "inference/contact_forces.hpp"
#include "io/film.hpp"
#include "io/film_result_file.hpp"
#include "io/read_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "study/film_checks.hpp"
#include "study/film_correction.hpp"
#include "study/film_forces.hpp"
#include "study/film_numbers.hpp"
#include "study/film_place.hpp"
#include "study/film_twin.hpp"
#include "study/find_grains.hpp"
#include "study/result_folder.hpp"
#include "thermography/grain_means.hpp"
#include "thermography/grain_motion.hpp"
#include "thermography/lockin.hpp"
#include "thermography/phase_pictures.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;
constexpr double turn = 2 * std::numbers::pi;

/// Adds the bytes of a file that need not fit into memory.
void add_file(HashBuilder& hash, const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string part(std::size_t{8} << 20, '\0');
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    hash.add("part", content_hash(part.substr(0, static_cast<std::size_t>(file.gcount()))));
}

/// Hash of the film and of all files that its recipe names, and of the recipe.
std::string film_key(const fs::path& film, const FilmRecipe& recipe) {
  HashBuilder hash;
  hash.add("recipe", to_toml(recipe));
  if (fs::is_regular_file(film)) add_file(hash, film);
  else hash.add("film", film.string());
  const auto add = [&](const char* name, const std::string& file) {
    if (!file.empty()) hash.add(name, content_hash(io::read_file(fs::path(recipe.source_file).parent_path() / file)));
  };
  add("cold", recipe.correction.cold);
  add("warm", recipe.correction.warm);
  add("curve", recipe.temperature.curve);
  add("grains", recipe.picture.grains);
  add("optical", recipe.picture.optical);
  if (recipe.twin) add("twin", recipe.twin->recipe);
  return hash.hex();
}

/// One run of the road, from the film to the result.
class Road {
 public:
  Road(const FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& source)
      : recipe_(recipe), options_(options), source_(source), place_(place_of(recipe, source.info())) {}

  /// False if it was stopped. What is wrong with the film is said with the film's name.
  bool run(FilmResult& r, const std::string& name) {
    try {
      return walk(r);
    } catch (const InputError& error) {
      auto problems = error.problems();
      for (auto& problem : problems)
        if (problem.file.empty()) problem.file = name;
      throw InputError(std::move(problems));
    }
  }

 private:
  bool walk(FilmResult& r) {
    r.film = source_.info();
    r.film.time.clear();
    r.pixel = place_.pixel;
    r.origin = place_.origin;
    const auto made = make_correction(recipe_, source_);
    for (const auto& note : made.notes) options_.notice(note);
    r.bad = made.bad;
    r.film.quantity = made.kelvin ? FilmQuantity::kelvin : FilmQuantity::digital_level;
    thermography::CorrectedFilm film(source_, made.correction);
    return lock_in(film, r) && find(film, r) && measure(r);
  }

  thermography::LockinOptions lockin_options(const char* name, std::size_t stage) const {
    thermography::LockinOptions o;
    o.frequency = recipe_.lockin.frequency;
    o.drift_order = static_cast<int>(recipe_.lockin.drift);
    o.harmonics = static_cast<int>(recipe_.lockin.harmonics);
    o.convention = SwingConvention::full;
    if (recipe_.lockin.phase) o.reference_phase = turn * *recipe_.lockin.phase;
    o.threads = options_.threads;
    o.progress = [this, name, stage](double share) {
      options_.progress({stage, 5, name, share, 0, 0, false, false});
      return !options_.asked_to_stop();
    };
    return o;
  }

  bool lock_in(FilmSource& film, FilmResult& r) {
    const auto options = lockin_options("lock-in", 1);
    r.maps = recipe_.lockin.method == LockinSection::Method::nearest_bin ? thermography::nearest_bin_transform(film, options)
                                                                         : thermography::lock_in(film, options);
    if (r.maps.size() == 0) return false;
    refuse_without_load(r.maps, recipe_.lockin.frequency);
    return true;
  }

  static std::size_t nearest_picture(const thermography::PhasePictures& pictures, double phase) {
    std::size_t best = 0;
    double most = -2;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      const double along = pictures.cosine[k] * std::cos(phase) + pictures.sine[k] * std::sin(phase);
      if (along > most) most = along, best = k;
    }
    return best;
  }

  bool find(FilmSource& film, FilmResult& r) {
    const auto pictures = thermography::phase_pictures(film, r.maps, lockin_options("pictures", 2));
    if (pictures.size() == 0) return false;
    const double largest = r.maps.reference_phase;
    const std::size_t smallest = nearest_picture(pictures, largest + std::numbers::pi);
    r.picture = thermography::picture_of(pictures, smallest);
    // The spline's coefficients are the picture with most of the pixels' blur undone: more rims are seen in it.
    const std::vector<float> sharp(pictures.picture(smallest), pictures.picture(smallest) + pictures.pixels());
    std::vector<std::string> notes;
    r.grains = find_film_grains(recipe_, place_, r.film, sharp, notes);
    for (const auto& note : notes) options_.notice(note);
    loaded_ = r.grains;
    if (recipe_.lockin.motion) follow(pictures, r);
    return true;
  }

  /// Fits the grains' motion and locks in where they are. Grains are found at the smallest load; in the middle of the
  /// swing they are half their travel further. What swings most is the load at its largest: contacts are as they are then,
  /// so the maps show the grains there.
  void follow(const thermography::PhasePictures& pictures, FilmResult& r) {
    const double largest = r.maps.reference_phase;
    PictureGrains middle = r.grains;
    thermography::GrainMotionOptions options;
    options.threads = options_.threads;
    for (int round = 0; round < 3; ++round) {
      r.motion = thermography::grain_motion(pictures, middle, options);
      for (std::size_t i = 0; i < r.grains.size(); ++i) {
        const double x = r.motion.cos_x[i] * std::cos(largest) + r.motion.sin_x[i] * std::sin(largest);
        const double y = r.motion.cos_y[i] * std::cos(largest) + r.motion.sin_y[i] * std::sin(largest);
        middle.x[i] = r.grains.x[i] + x, middle.y[i] = r.grains.y[i] + y;
        loaded_.x[i] = r.grains.x[i] + 2 * x, loaded_.y[i] = r.grains.y[i] + 2 * y;
      }
    }
    std::optional<double> phase;
    if (recipe_.lockin.phase) phase = turn * *recipe_.lockin.phase;
    r.maps = thermography::follow_grains(pictures, r.maps, middle, r.motion, loaded_, phase, options_.threads, recipe_.forces.blur);
    forget_outside(r.maps);
  }

  /// Where rims sweep over a pixel it shows their motion and no warming.
  void forget_outside(LockinMaps& maps) const {
    std::vector<std::uint8_t> inside(maps.size(), 0);
    for (std::size_t i = 0; i < loaded_.size(); ++i) {
      const double x = loaded_.x[i], y = loaded_.y[i], radius = loaded_.radius[i];
      for (int row = std::max(0, static_cast<int>(y - radius)); row <= std::min(maps.height - 1, static_cast<int>(y + radius)); ++row)
        for (int column = std::max(0, static_cast<int>(x - radius)); column <= std::min(maps.width - 1, static_cast<int>(x + radius)); ++column)
          if (std::hypot(column - x, row - y) <= radius)
            inside[static_cast<std::size_t>(row) * static_cast<std::size_t>(maps.width) + static_cast<std::size_t>(column)] = 1;
    }
    for (auto* map : {&maps.amplitude, &maps.phase, &maps.in_phase, &maps.quadrature, &maps.second_harmonic, &maps.standard_error, &maps.residual})
      for (std::size_t p = 0; p < map->size(); ++p)
        if (!inside[p]) (*map)[p] = std::numeric_limits<float>::quiet_NaN();
  }

  bool measure(FilmResult& r) {
    options_.progress({3, 5, "grains", 0, 0, 0, false, false});
    thermography::GrainMeanOptions means;
    means.share = recipe_.forces.central_share;
    for (const auto& m : recipe_.materials) means.factor.push_back(m.thermoelastic_factor);
    r.swing = thermography::grain_means(r.maps, loaded_, means);
    r.packing.materials = materials_of(recipe_);
    r.packing.grains = in_metres(loaded_, place_);
    r.packing.domain = frame_at(recipe_, recipe_.lockin.motion ? 1 : 0);
    infer_film_forces(recipe_, r);
    options_.progress({3, 5, "grains", 1, 0, 0, false, false});
    return !options_.asked_to_stop();
  }

  const FilmRecipe& recipe_;
  const FilmRunOptions& options_;
  FilmSource& source_;
  FilmPlace place_;
  PictureGrains loaded_;            ///< at the largest load
};

bool add_twin(const FilmRecipe& recipe, const FilmRunOptions& options, FilmOutcome& outcome) {
  RunOptions run;
  run.out = options.out / "twin";
  run.notice = options.notice;
  run.asked_to_stop = options.asked_to_stop;
  run.progress = [&](const Progress& p) {
    Progress shown = p;
    shown.name = "twin: " + p.name;
    shown.stage = 10 + p.stage;
    shown.stages = 11 + p.stages;
    options.progress(shown);
  };
  auto twin = run_twin(recipe, outcome.result, run);
  if (twin.interrupted) return false;
  outcome.result.twin = std::move(twin.stresses);
  outcome.twin = std::move(twin.stages);
  if (!twin.converged) options.notice("the simulation beside the film found no equilibrium: " + twin.outcome);
  return true;
}

std::string sentence_of(const FilmResult& r) {
  return fmt::format("{} grains and {} contacts at {:.6g} Hz", r.packing.grains.size(), r.packing.contacts.size(), r.maps.frequency);
}

/// What the store has of this film; nothing for a file that is missing or damaged.
std::optional<FilmResult> stored(const fs::path& file, const FilmRunOptions& options) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    return io::read_film_result(file);
  } catch (const io::DamagedFile&) {
    options.notice(fmt::format("{}: is empty, cut short or changed; the film is measured again", file.string()));
    return std::nullopt;
  }
}

}  // namespace

FilmOutcome run_film(const fs::path& film, const FilmRecipe& recipe, const FilmRunOptions& options) {
  FilmOutcome outcome;
  const auto source = io::open_film(film);
  const std::string key = film_key(film, recipe);
  if (recipe.twin) read_twin_recipe(recipe);
  outcome.file = options.out / io::stage_file_name(1, "film", key);
  FilmResult& r = outcome.result;
  if (auto known = stored(outcome.file, options)) {
    r = std::move(*known);
    outcome.interrupted = recipe.twin && !add_twin(recipe, options, outcome);
    return outcome;
  }
  r.name = "film";
  Road road(recipe, options, *source);
  if (!road.run(r, film.string())) {
    outcome.interrupted = true;
    return outcome;
  }
  make_folder(options.out);
  if (recipe.twin && !add_twin(recipe, options, outcome)) {
    outcome.interrupted = true;
    return outcome;
  }
  r.numbers_json = film_numbers(r);
  r.outcome = sentence_of(r);
  r.provenance = {version, "film", key, to_toml(recipe), recipe.seed, "", {{"film", film.filename().string()}}};
  io::write_film_result(outcome.file, r);
  return outcome;
}

}  // namespace arenite::study
