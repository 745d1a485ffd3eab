#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "support/film_accuracy.hpp"
#include "support/laboratory_film.hpp"
#include "support/laboratory_inputs.hpp"

/// film_disturbances [GRAINS [SEED [NAME...]]]: films of one sample, each with one property of the laboratory off,
/// measured by its recipe and held against the truth: a row of the table in docs/forces.md each.
namespace {

using namespace arenite;
using test::LaboratoryFilm, test::LaboratorySample, test::DrawnFilm;

struct Row {
  const char* name;
  std::function<void(LaboratoryFilm&)> camera;
  std::function<void(recipe::FilmRecipe&)> laboratory;
  enum class Grains { found, listed, optical } grains = Grains::found;
};

const std::vector<Row> rows{
    {"as given", {}, {}},
    {"halo 10 %, 4 px", [](auto& f) { f.halo = 0.1; }, {}},
    {"halo 20 %, 4 px", [](auto& f) { f.halo = 0.2; }, {}},
    {"A told +10 %",
     {},
     [](auto& r) {
       for (auto& m : r.materials) m.thermoelastic_factor *= 1.1;
     }},
    {"A of POM told +5 %", {}, [](auto& r) { r.materials[0].thermoelastic_factor *= 1.05; }},
    {"thickness told +5 %", {}, [](auto& r) { r.container.thickness *= 1.05; }},
    {"load told +3 %, error 3 %",
     {},
     [](auto& r) { r.container.load_peak_to_peak *= 1.03, r.container.load_error = 0.03; }},
    {"emissivity of HDPE told +5 %", [](auto& f) { f.emissivity[1] /= 1.05; },
     [](auto& r) { r.materials[1].emissivity = 0.75; }},
    {"emissivity +-3 % by grain", [](auto& f) { f.emissivity_scatter = 0.03; }, {}},
    {"left off by 0.6 px", {}, [](auto& r) { *r.container.left += 0.6; }},
    {"left off by 1.2 px", {}, [](auto& r) { *r.container.left += 1.2; }},
    {"top off by 0.6 px", {}, [](auto& r) { *r.container.top += 0.6; }},
    {"blur told 0.6 px", {}, [](auto& r) { r.forces.blur = 0.6; }},
    {"1/f noise of all pixels 20 mK", [](auto& f) { f.common = 0.02; }, {}},
    {"1/f noise of columns 20 mK", [](auto& f) { f.columns = 0.02; }, {}},
    {"2.7 % of frames lost", [](auto& f) { f.lost = 0.027; }, {}},
    {"level jump 0.1 K", [](auto& f) { f.jump = 0.1; }, {}},
    {"three jumps by pixel 30 mK",
     [](auto& f) {
       f.jump_pattern = 0.03, f.jump_at = {0.21, 0.54, 0.83};
     },
     {}},
    {"warm-up 0.3 K in a fifth", [](auto& f) { f.drift = [](double x) { return -0.3 * std::exp(-5 * x); }; }, {}},
    {"warm-up 0.3 K in a twentieth", [](auto& f) { f.drift = [](double x) { return -0.3 * std::exp(-20 * x); }; }, {}},
    {"drift of 2.5 waves of 0.3 K",
     [](auto& f) { f.drift = [](double x) { return 0.3 * std::sin(5 * std::numbers::pi * x); }; },
     {}},
    {"noise 50 mK", [](auto& f) { f.noise = 0.05; }, {}},
    {"isothermal, grains listed", [](auto& f) { f.ambient = f.temperature; }, {}, Row::Grains::listed},
    {"isothermal, optical picture", [](auto& f) { f.ambient = f.temperature; }, {}, Row::Grains::optical},
    {"optical picture", {}, {}, Row::Grains::optical},
    {"grains listed", {}, {}, Row::Grains::listed},
};

void report(const Row& row, const LaboratorySample& sample, std::uint64_t seed) {
  LaboratoryFilm how;
  how.seed = seed;
  if (row.camera) row.camera(how);
  DrawnFilm drawn(sample.packing, how);
  recipe::FilmRecipe recipe = laboratory_recipe(sample, how, drawn);
  const test::TemporaryFolder folder;
  if (row.grains == Row::Grains::listed) recipe.picture.grains = list_of_grains(sample, how, folder);
  if (row.grains == Row::Grains::optical) {
    recipe.picture.optical = optical_picture(sample, how, drawn, folder), recipe.picture.optical_pixel = how.pixel / 3;
    recipe.materials[0].brightness = 0.1, recipe.materials[1].brightness = 0.9;
  }
  if (row.laboratory) row.laboratory(recipe);
  try {
    const test::FilmAccuracy a = measured(sample, how, drawn, recipe);
    std::printf("| %-28s | %3zu | %3zu/%3zu | %.3f/%.3f | %5.2f/%5.2f | %.2f/%.2f | %5.2f/%5.2f | %.2f/%.2f |\n",
                row.name, a.grains, a.contacts, a.true_contacts, a.centres, a.centres_told, 100 * a.stress,
                100 * a.stress_told, a.stress_within_one, a.stress_within_two, 100 * a.force, 100 * a.force_told,
                a.within_one, a.within_two);
    for (const auto& sentence : a.said) std::printf("    %s\n", sentence.c_str());
    for (std::size_t m = 0; m < a.result.fit.factor_scale.size(); ++m)
      std::printf("    scale %zu %.4f +- %.4f\n", m, a.result.fit.factor_scale[m], a.result.fit.factor_scale_error[m]);
    std::printf(
        "    over noise %.2f, model error %.4f, blur %.3f, centres at the smallest load %.3f/%.3f, scale %+.3f %%\n",
        a.result.fit.over_noise, a.result.fit.model_error, a.result.rim_blur, a.centres_low, a.centres_low_told,
        100 * a.scale);
  } catch (const std::exception& e) { std::printf("| %-28s | refused: %s\n", row.name, e.what()); }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t grains = argc > 1 ? static_cast<std::size_t>(std::atoi(argv[1])) : 60;
  const std::uint64_t seed = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1;
  const LaboratorySample sample(grains, seed);
  for (const Row& row : rows) {
    bool wanted = argc <= 3;
    for (int k = 3; k < argc; ++k) wanted = wanted || std::string(row.name).find(argv[k]) != std::string::npos;
    if (wanted) report(row, sample, seed);
  }
}
