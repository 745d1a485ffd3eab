#include "workflow/film_twin.hpp"

#include <fmt/format.h>

#include <numbers>

#include "io/atomic_file.hpp"
#include "workflow/film_checks.hpp"
#include "workflow/film_place.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

/// The grains at the smallest load as a table that recipes read; lengths count from the frame's lower left corner.
std::string table_of(const FilmResult& film) {
  const Grains grains = in_metres(film.grains, {film.origin, film.pixel});
  std::string text = "id,x [m],y [m],radius [m],material\n";
  for (std::size_t i = 0; i < grains.size(); ++i)
    text += fmt::format("{},{},{},{},{}\n", grains.id[i], grains.x[i], grains.y[i], grains.radius[i],
                        film.packing.materials[static_cast<std::size_t>(grains.material[i])].name);
  return text;
}

Recipe twin_recipe(const FilmRecipe& recipe, const fs::path& grains) {
  Recipe twin = read_twin_recipe(recipe);
  twin.populations.clear();
  twin.packing.method = PackingParameters::Method::file;
  twin.packing.file = fs::absolute(grains).string();
  twin.frame.width = recipe.frame.width;
  twin.frame.height = recipe.frame.height;
  return twin;
}

Packing last_of(const StageResult& stage) { return stage.frames.back().packing; }

}  // namespace

std::vector<double> stress_of_disks(const Packing& packing) {
  const Contacts& contacts = packing.contacts;
  std::vector<double> pushed(packing.grains.size(), 0.0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    pushed[static_cast<std::size_t>(contacts.i[c])] += contacts.fn[c];
    if (!contacts.is_wall(c)) pushed[static_cast<std::size_t>(contacts.j[c])] += contacts.fn[c];
  }
  for (std::size_t i = 0; i < pushed.size(); ++i) pushed[i] /= -2 * std::numbers::pi * packing.grains.radius[i] * packing.domain.thickness;
  return pushed;
}

TwinRun run_twin(const FilmRecipe& recipe, const FilmResult& film, const RunOptions& options) {
  make_folder(options.out);
  const fs::path grains = options.out / "grains.csv";
  io::write_atomically(grains, table_of(film));
  auto outcome = run(twin_recipe(recipe, grains), options);
  TwinRun twin;
  twin.converged = outcome.converged;
  twin.interrupted = outcome.interrupted;
  const StageResult *low = nullptr, *high = nullptr;
  for (const StageResult& stage : outcome.stages) {
    if (stage.name == recipe.twin->low) low = &stage;
    if (stage.name == recipe.twin->high) high = &stage;
    twin.outcome = stage.outcome;
  }
  if (low && high) {
    twin.loaded = last_of(*high);
    const auto released = stress_of_disks(last_of(*low));
    twin.stresses.state = stress_of_disks(twin.loaded);
    for (std::size_t i = 0; i < released.size(); ++i) twin.stresses.swing.push_back(twin.stresses.state[i] - released[i]);
  }
  twin.stages = std::move(outcome.stages);
  return twin;
}

}  // namespace arenite::study
