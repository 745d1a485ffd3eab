#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "statistics/measured.hpp"
#include "support/film_accuracy.hpp"
#include "support/laboratory_film.hpp"
#include "support/laboratory_inputs.hpp"

/// film_disturbances [GRAINS [SEEDS [NAME...]]]: films of samples, each with one property of the laboratory off,
/// measured by its recipe and held against the truth. SEEDS is a number or a range (1..10); after the seeds of a row
/// comes what they are together: a row of the table in docs/forces.md. With DETAILS=1 each film is shown, too.
namespace {

using namespace arenite;
using test::LaboratoryFilm, test::LaboratorySample, test::DrawnFilm;

/// Constants of which a recipe tells a standard error are off by draws of it, one a sample: errors told are of them,
/// too, and those of one sample share them. What is off by a fixed amount is there to be found. Ten seeds in a row
/// (1..10, 11..20) have each constant in every tenth of the normal law once, in an order of its own: of so few draws
/// the scatter is what the law says it is.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : order_((seed - 1) / tenths, Purpose::test, 79), at_((seed - 1) % tenths) {}
  double times(double error) {
    std::array<double, tenths> share{};
    for (std::size_t k = 0; k < tenths; ++k) share[k] = (static_cast<double>(k) + order_.uniform()) / tenths;
    for (std::size_t k = tenths - 1; k > 0; --k)
      std::swap(share[k], share[static_cast<std::size_t>(order_.uniform(0, static_cast<double>(k + 1)))]);
    constexpr double many = 1e6;  // degrees of freedom of a normal number
    return 1 + error * statistics::student_quantile(share[at_], many);
  }

 private:
  static constexpr std::size_t tenths = 10;
  RandomStream order_;
  std::size_t at_;
};

struct Row {
  const char* name;
  std::function<void(LaboratoryFilm&)> camera;
  std::function<void(recipe::FilmRecipe&)> laboratory;
  enum class Grains { found, listed, optical } grains = Grains::found;
  bool exact = false;  ///< the constants are those told
};

const std::vector<Row> rows{
    {"constants exact", {}, {}, Row::Grains::found, true},
    {"as given", {}, {}},
    {"halo 10 %, 4 px", [](auto& f) { f.halo = 0.1; }, {}},
    {"halo 20 %, 4 px", [](auto& f) { f.halo = 0.2; }, {}},
    {"halo 4 %, 4 px", [](auto& f) { f.halo = 0.04; }, {}},
    {"A told +10 %",
     {},
     [](auto& r) {
       for (auto& m : r.materials) m.thermoelastic_factor *= 1.1;
     }},
    {"A of POM told +5 %", {}, [](auto& r) { r.materials[0].thermoelastic_factor *= 1.05; }},
    {"thickness told +5 %", {}, [](auto& r) { r.container.thickness *= 1.05; }},
    {"load known to 3 %", {}, [](auto& r) { r.container.load_error = 0.03; }},
    {"emissivity of HDPE told +5 %", [](auto& f) { f.emissivity[1] /= 1.05; },
     [](auto& r) { r.materials[1].emissivity = 0.75; }},
    {"emissivity +-3 % by grain", [](auto& f) { f.emissivity_scatter = 0.03; }, {}},
    {"left off by 0.6 px", {}, [](auto& r) { *r.container.left += 0.6; }},
    {"left off by 1.2 px", {}, [](auto& r) { *r.container.left += 1.2; }},
    {"top off by 0.6 px", {}, [](auto& r) { *r.container.top += 0.6; }},
    {"blur told 0.6 px", {}, [](auto& r) { r.forces.blur = 0.6; }},
    {"blur told 0.8 px", {}, [](auto& r) { r.forces.blur = 0.8; }},
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
    {"3 grains without paint, listed",
     [](auto& f) {
       f.bare = {0.2, 0.45, 0.69};
     },
     {},
     Row::Grains::listed},
};

/// A sentence without its numbers: by which those of several films are one.
std::string kind_of(const std::string& sentence) {
  std::string kind;
  for (const char c : sentence)
    if (!std::isdigit(static_cast<unsigned char>(c)) && c != '.' && c != '-') kind += c;
  return kind;
}

/// The films of a row, together.
class Pooled {
 public:
  void add(const test::FilmAccuracy& a) {
    const auto n = static_cast<double>(a.forces);
    films_ += 1, forces_ += n;
    one_ += n * a.within_one, two_ += n * a.within_two;
    stress_one_ += a.stress_within_one, stress_two_ += a.stress_within_two;
    stress_ += a.stress * a.stress, stress_told_ += a.stress_told * a.stress_told;
    force_ += a.force * a.force, force_told_ += a.force_told * a.force_told;
    common_ += a.common * a.common;
    std::map<std::string, std::string> once;
    for (const auto& sentence : a.said) once.emplace(kind_of(sentence), sentence);
    for (const auto& [kind, sentence] : once) ++said_.try_emplace(kind, Said{0, sentence}).first->second.films;
  }
  void refuse(const std::string& why) {
    refused_ += 1;
    ++said_.try_emplace(kind_of(why), Said{0, "refused: " + why}).first->second.films;
  }

  void print(const char* name) const {
    const auto rms = [&](double squares) { return 100 * std::sqrt(squares / films_); };
    std::printf("| %-29s | %.2f / %.2f | %.2f, %.2f | %.2f / %.2f | %.2f | %.2f | %.2f |\n", name, rms(stress_),
                rms(stress_told_), stress_one_ / films_, stress_two_ / films_, rms(force_), rms(force_told_),
                one_ / forces_, two_ / forces_, rms(common_));
    for (const auto& [kind, said] : said_)
      if (kind.find("gives the band of the camera") == std::string::npos)
        std::printf("    in %d of %.0f: %s\n", said.films, films_ + refused_, said.sentence.c_str());
  }

 private:
  struct Said {
    int films;
    std::string sentence;
  };
  double films_ = 0, refused_ = 0, forces_ = 0, one_ = 0, two_ = 0, stress_one_ = 0, stress_two_ = 0;
  double stress_ = 0, stress_told_ = 0, force_ = 0, force_told_ = 0, common_ = 0;  // squares
  std::map<std::string, Said> said_;
};

void print_film(const Row& row, std::uint64_t seed, const test::FilmAccuracy& a) {
  std::printf("| %-28s %3d | %3zu | %3zu/%3zu | %.3f/%.3f | %5.2f/%5.2f | %.2f/%.2f | %5.2f/%5.2f | %.2f/%.2f |\n",
              row.name, static_cast<int>(seed), a.grains, a.contacts, a.true_contacts, a.centres, a.centres_told,
              100 * a.stress, 100 * a.stress_told, a.stress_within_one, a.stress_within_two, 100 * a.force,
              100 * a.force_told, a.within_one, a.within_two);
  for (const auto& sentence : a.said) std::printf("    %s\n", sentence.c_str());
  for (std::size_t m = 0; m < a.result.fit.factor_scale.size(); ++m)
    std::printf("    scale %zu %.4f +- %.4f\n", m, a.result.fit.factor_scale[m], a.result.fit.factor_scale_error[m]);
  std::printf(
      "    over noise %.2f, model error %.4f, blur %.3f, centres at the smallest load %.3f/%.3f, scale %+.3f %%, "
      "forces "
      "%+.2f %%\n",
      a.result.fit.over_noise, a.result.fit.model_error, a.result.rim_blur, a.centres_low, a.centres_low_told,
      100 * a.scale, 100 * a.common);
}

test::FilmAccuracy film_of(const Row& row, const LaboratorySample& sample, std::uint64_t seed) {
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
  if (Draw draw(seed); !row.exact) {
    recipe.container.load_peak_to_peak *= draw.times(recipe.container.load_error);
    for (auto& m : recipe.materials) m.thermoelastic_factor *= draw.times(recipe.forces.factor_error);
  }
  return measured(sample, how, drawn, recipe);
}

void report(const Row& row, const std::vector<LaboratorySample>& samples, std::uint64_t first, bool details) {
  Pooled all;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::uint64_t seed = first + k;
    try {
      const test::FilmAccuracy a = film_of(row, samples[k], seed);
      if (details) print_film(row, seed, a);
      all.add(a);
    } catch (const std::exception& e) { all.refuse(e.what()); }
    std::fflush(stdout);
  }
  all.print(row.name);
  std::fflush(stdout);
}

/// "3" or "1..10".
std::pair<std::uint64_t, std::uint64_t> seeds_of(std::string_view text) {
  std::uint64_t first = 1, last = 1;
  const auto dots = text.find("..");
  std::from_chars(text.data(), text.data() + std::min(dots, text.size()), first);
  last = first;
  if (dots != std::string_view::npos) std::from_chars(text.data() + dots + 2, text.data() + text.size(), last);
  return {first, std::max(first, last)};
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t grains = argc > 1 ? static_cast<std::size_t>(std::atoi(argv[1])) : 60;
  const auto [first, last] = seeds_of(argc > 2 ? argv[2] : "1");
  const bool details = std::getenv("DETAILS") != nullptr;
  std::vector<LaboratorySample> samples;
  for (std::uint64_t seed = first; seed <= last; ++seed) samples.emplace_back(grains, seed);
  for (const Row& row : rows) {
    bool wanted = argc <= 3;
    for (int k = 3; k < argc; ++k) wanted = wanted || std::string(row.name).find(argv[k]) != std::string::npos;
    if (wanted) report(row, samples, first, details);
  }
}
