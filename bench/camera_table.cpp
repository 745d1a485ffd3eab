#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "grains/texture/texture.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "workflow/film/render_film.hpp"
#include "workflow/film/run_film.hpp"

/// camera_table STATES CAMERA.toml SCRATCH [THREADS [WORDS...]]: films simulated states with one property of the camera
/// changed at a time, measures each film without knowing what was drawn, and prints what grains, stresses and forces
/// are off by. Where grains are not found, it goes on with a list of their true places.
namespace {

using namespace arenite;
namespace fs = std::filesystem;
using Pair = std::pair<int, int>;

/// Force of contact c on the grain with the greater number, or on the grain that touches a wall.
std::pair<Pair, Vec2> named(int i, int j, Vec2 force_on_i) {
  if (j >= 0 && i < j) return {{j, i}, -1 * force_on_i};
  return {{i, j}, force_on_i};
}

struct Truth {
  Packing low, high;
  Vec2 corner;                 ///< lower left inner corner at the smallest load
  std::vector<double> stress;  ///< peak to peak, by normal forces, Pa
  std::map<Pair, Vec2> force;  ///< peak to peak, of contacts, N
  std::vector<std::uint8_t> considered;

  Truth(Packing released, Packing loaded)
      : low(std::move(released)),
        high(std::move(loaded)),
        stress(high.grains.size(), 0.0) {
    corner = low.domain.corner();
    add(high, 1);
    add(low, -1);
    texture::Options options;
    options.rev.sizes = 0;
    considered = texture::measure(high, options).per_grain.considered;
  }

 private:
  void add(const Packing& state, double sign) {
    const auto press = [&](std::int32_t grain, double fn) {
      const auto g = static_cast<std::size_t>(grain);
      stress[g] -= sign * fn / (2 * std::numbers::pi * state.grains.radius[g] * state.domain.thickness);
    };
    const Contacts& contacts = state.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      press(contacts.i[c], contacts.fn[c]);
      if (!contacts.is_wall(c)) press(contacts.j[c], contacts.fn[c]);
      const auto [pair, vector] = named(contacts.i[c], contacts.j[c], contacts.force_on_i(c));
      force[pair] = force[pair] + sign * vector;
    }
  }
};

Packing last_state(const fs::path& states, const std::string& stage) {
  for (const auto& file : io::stage_files(states))
    if (file.filename().string().find("-" + stage + "-") != std::string::npos)
      return io::read_stage(file).snapshots.back().packing;
  throw std::runtime_error("no stage " + stage);
}

struct Errors {
  std::size_t found = 0, missed = 0, wrong_material = 0;
  double centres = 0;  ///< root mean square at the smallest load, pixels along one axis
  inference::Agreement stress;
  double normal = 0, tangential = 0;  ///< relative L2 errors of contacts between grains
};

void compare_forces(const Truth& truth, const FilmResult& film, const std::vector<std::size_t>& match, Errors& e) {
  double off_n = 0, off_t = 0, all_n = 0, all_t = 0;
  auto left_over = truth.force;
  const Contacts& contacts = film.packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c)) continue;
    const auto partner = [&](std::int32_t grain) { return static_cast<int>(match[static_cast<std::size_t>(grain)]); };
    const auto [pair, direction] = named(partner(contacts.i[c]), partner(contacts.j[c]), contacts.normal[c]);
    Vec2 f;
    if (const auto it = left_over.find(pair); it != left_over.end()) f = it->second, left_over.erase(it);
    const double fn = dot(f, direction), ft = f.y * direction.x - f.x * direction.y;
    off_n += std::pow(contacts.fn[c] - fn, 2), all_n += fn * fn;
    off_t += std::pow(contacts.ft[c] - ft, 2), all_t += ft * ft;
  }
  for (const auto& [pair, f] : left_over)
    if (pair.second >= 0) off_n += dot(f, f), all_n += dot(f, f);
  e.normal = std::sqrt(off_n / all_n);
  e.tangential = std::sqrt(off_t / all_t);
}

Errors compare(const Truth& truth, const FilmResult& film) {
  Errors e;
  const std::size_t grains = film.packing.grains.size();
  std::vector<std::size_t> match(grains, 0);
  std::vector<std::uint8_t> seen(truth.low.grains.size(), 0), counts;
  std::vector<double> change;
  double square = 0;
  for (std::size_t i = 0; i < grains; ++i) {
    const Vec2 at =
        film.origin + Vec2{film.grains.centre[i].x * film.pixel, -film.grains.centre[i].y * film.pixel} + truth.corner;
    for (std::size_t k = 1; k < seen.size(); ++k)
      if (norm(truth.low.grains.position[k] - at) < norm(truth.low.grains.position[match[i]] - at)) match[i] = k;
    const std::size_t k = match[i];
    square += std::pow(norm(truth.low.grains.position[k] - at) / film.pixel, 2) / 2;
    seen[k] = 1;
    e.wrong_material += film.packing.materials[static_cast<std::size_t>(film.packing.grains.material[i])].name !=
                        truth.low.materials[static_cast<std::size_t>(truth.low.grains.material[k])].name;
    change.push_back(truth.stress[k]);
    counts.push_back(truth.considered[k]);
  }
  for (const auto s : seen) e.missed += s == 0;
  e.found = grains;
  e.centres = std::sqrt(square / static_cast<double>(grains));
  e.stress = inference::agreement(film.peak_to_peak.sigma_hyd, change, counts);
  compare_forces(truth, film, match, e);
  return e;
}

/// The sample stands at the largest load and the load is put on and off without moving a grain.
Truth resting(const Truth& truth) {
  Packing unloaded = truth.high;
  unloaded.contacts = {};
  return {unloaded, truth.high};
}

/// Grains as one lists them who finds them in a fine picture; lengths count from the container's lower left inner
/// corner.
void list_grains(const fs::path& file, const Truth& truth) {
  const Grains& grains = truth.low.grains;
  std::ofstream table(file);
  table << "id,x [m],y [m],radius [m],material\n";
  for (std::size_t i = 0; i < grains.size(); ++i)
    table << i + 1 << ',' << grains.position[i].x - truth.corner.x << ',' << grains.position[i].y - truth.corner.y
          << ',' << grains.radius[i] << ',' << truth.low.materials[static_cast<std::size_t>(grains.material[i])].name
          << '\n';
}

/// True if most grains were found.
bool row(const char* name, const std::vector<std::string>& changes, const Truth& truth, bool listed, char** argv,
         int threads) {
  const fs::path folder = fs::path(argv[3]) / "film";
  fs::remove_all(folder);
  const auto recipe = recipe::read_film_recipe(argv[2], changes);
  workflow::RenderOptions render;
  render.out = folder;
  workflow::render_film(recipe, argv[1], render);
  workflow::FilmRunOptions run;
  run.out = folder / "result";
  run.threads = threads;
  std::vector<std::string> given{"forces.state=false"};
  if (listed) list_grains(folder / "grains.csv", truth), given.emplace_back("picture.grains=\"grains.csv\"");
  const auto outcome =
      workflow::run_film(folder / "film.ptw", recipe::read_film_recipe((folder / "film.toml").string(), given), run);
  const Errors e = compare(truth, outcome.result);
  std::printf("| %s%s | %zu | %zu | %zu | %.3f | %.4f | %.4f | %.4f | %.1f | %.1f |\n", name,
              listed ? ", grains listed" : "", e.found, e.missed, e.wrong_material, e.centres,
              e.stress.relation.pearson.value, e.stress.rms_sigma_norm, e.stress.relation.line.slope, 100 * e.normal,
              100 * e.tangential);
  std::fflush(stdout);
  return 10 * e.missed < e.found;
}

/// As a whole number of pixels: the frame of 350 mm and a margin.
std::vector<std::string> pixel_of(double mm) {
  const std::string side = std::to_string(static_cast<int>(std::ceil(350 / mm)) + 22);
  char text[48];
  std::snprintf(text, sizeof text, "camera.pixel=\"%g mm\"", mm);
  return {text, "camera.width=" + side, "camera.height=" + side};
}

constexpr const char* at_rest = "camera.low=\"\"";

struct Row {
  const char* name;
  std::vector<std::string> changes;
  double pixel = 1.6;
  bool listed = false;  ///< grains are not looked for
};

/// Each source of error switched off, then what a laboratory can choose; rows that matter most come first.
std::vector<Row> rows() {
  const std::string no_noise[] = {"camera.netd=\"0 mK\"", "camera.electrons=1e14", "camera.full_well=2e14"};
  return {{"20 mK, 1.6 mm, 0.5 px, moving", {}},
          {"nothing moves", {at_rest}},
          {"no noise", {no_noise[0], no_noise[1], no_noise[2]}},
          {"no blur", {"camera.blur=0"}},
          {"no spread of pixels, none bad",
           {"camera.gain_spread=\"0 %\"", "camera.offset_spread=\"0 %\"", "camera.bad_share=\"0 %\""}},
          {"no drift, harmonic, lost frames; frequency true",
           {"camera.drift=\"0 mK/s\"", "camera.second_harmonic=\"0 %\"", "camera.dropped=\"0 %\"",
            "camera.frequency_error=\"0 %\""}},
          {"places and radii true", {}, 1.6, true},
          {"contacts press over arcs of 0.1 rad", {"camera.contact_arc=0.1"}},
          {"NETD 5 mK", {"camera.netd=\"5 mK\"", "camera.electrons=1.2e8", "camera.full_well=2.4e8"}},
          {"NETD 50 mK", {"camera.netd=\"50 mK\""}},
          {"lens 0.3 px", {"camera.blur=0.3"}},
          {"lens 0.8 px", {"camera.blur=0.8"}},
          {"pixel 1.0 mm", {}, 1.0},
          {"pixel 2.4 mm", {}, 2.4}};
}

void table(char** argv, int threads, const std::vector<std::string>& words) {
  const auto recipe = recipe::read_film_recipe(argv[2]);
  const Truth truth(last_state(argv[1], recipe.camera->low), last_state(argv[1], recipe.camera->high));
  std::printf(
      "| camera | grains | missed | wrong material | centres, px | correlation | rms of sigma_norm | slope | normal, "
      "%% | tangential, %% |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  const Truth still = resting(truth);
  const auto film_one = [&](Row r) {
    const Truth& seen = !r.changes.empty() && r.changes.front() == at_rest ? still : truth;
    for (auto& text : pixel_of(r.pixel)) r.changes.push_back(text);
    for (const bool listed : {false, true}) {
      if (r.listed && !listed) continue;
      try {
        if (row(r.name, r.changes, seen, listed, argv, threads)) return;
      } catch (const InputError& error) {
        std::printf("| %s | %s |\n", r.name, error.problems().front().message.c_str());
        std::fflush(stdout);
      }
    }
  };
  for (const Row& r : rows()) {
    const auto named_by = [&](const std::string& word) { return std::string(r.name).find(word) != std::string::npos; };
    if (words.empty() || std::any_of(words.begin(), words.end(), named_by)) film_one(r);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4)
    return std::fprintf(stderr,
                        "camera_table STATES CAMERA.toml SCRATCH [THREADS [WORDS...]]: folder of the simulated states, "
                        "recipe of the camera, folder for films, words that name rows (all rows)\n"),
           2;
  try {
    table(argv, argc > 4 ? std::atoi(argv[4]) : 1, {argv + std::min(argc, 5), argv + argc});
    return 0;
  } catch (const std::exception& e) { return std::fprintf(stderr, "%s\n", e.what()), 2; }
}
