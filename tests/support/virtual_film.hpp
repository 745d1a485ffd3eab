#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "support/program.hpp"

namespace arenite::test {

/// The example of a virtual experiment with 42 grains, 96 x 96 pixels and two seconds of film: all files in one folder.
class VirtualFilm {
 public:
  explicit VirtualFilm(const std::string& overrides = "") {
    const std::string force =
        " --set stages.1.bottom.force='\"16 kN\"' --set stages.2.bottom.force='\"1.6 kN\"' --set "
        "stages.3.bottom.force='\"16 kN\"'";
    const std::string increments =
        " --set stages.1.increments=2 --set stages.2.increments=2 --set stages.3.increments=2 --set "
        "integration.track_energy=false";
    simulated = arenite("run " + example("sample.toml") + " --quiet --out " + states() +
                        " --set populations.0.count=20 --set populations.1.count=22" +
                        " --set container.width='\"95 mm\"' --set packing.solid_fraction=0.7" + force + increments);
    filmed = camera("film", overrides);
  }

  static std::string example(const std::string& file) {
    return std::string(ARENITE_SOURCE_DIR) + "/examples/40-virtual-experiment/" + file;
  }
  static std::string small_camera() {
    return " --set camera.width=96 --set camera.height=96 --set camera.pixel='\"1.2 mm\"' --set camera.frames=300 "
           "--set camera.reference_frames=30";
  }

  std::string states() const { return (folder / "states").string(); }
  std::filesystem::path at(const std::string& name) const { return folder / name; }

  Outcome camera(const std::string& to, const std::string& overrides = "") const {
    return arenite("camera " + states() + " --recipe " + example("camera.toml") + " --quiet --out " + at(to).string() +
                   small_camera() + " " + overrides);
  }
  /// `arenite film` of the film in that folder by the recipe there, into the folder "result".
  Outcome film(const std::string& more = "", const std::string& from = "film",
               const std::string& recipe = "film.toml") const {
    return arenite("film " + at(from + "/film.ptw").string() + " --recipe " + at("film/" + recipe).string() +
                   " --quiet --out " + at("result").string() + " " + more);
  }
  /// The recipe of the film with one piece of text in place of another, beside it under this name.
  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = slurp(at("film/film.toml"));
    text.replace(text.find(from), from.size(), to);
    std::ofstream(at("film/" + name)) << text;
  }

  FilmResult result() const { return io::read_film_result(io::stage_files(at("result")).front()); }
  /// Last state of a simulated stage.
  Packing state(const std::string& stage) const {
    for (const auto& file : io::stage_files(states()))
      if (file.filename().string().find("-" + stage + "-") != std::string::npos)
        return io::read_stage(file).snapshots.back().packing;
    return {};
  }

  TemporaryFolder folder;
  Outcome simulated, filmed;
};

/// Stress of every grain as the sum of its normal forces tells it: sigma_hyd = -sum fn/(2 pi R L), Pa.
inline std::vector<double> stress_by_forces(const Packing& p) {
  constexpr double turn = 6.283185307179586;
  std::vector<double> sigma(p.grains.size(), 0.0);
  const auto add = [&](std::int32_t grain, double fn) {
    const auto g = static_cast<std::size_t>(grain);
    sigma[g] -= fn / (turn * p.grains.radius[g] * p.domain.thickness);
  };
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    add(p.contacts.i[c], p.contacts.fn[c]);
    if (!p.contacts.is_wall(c)) add(p.contacts.j[c], p.contacts.fn[c]);
  }
  return sigma;
}

/// For every place of `found` the nearest grain of `truth`; lower left inner corners of the frames lie on each other.
inline std::vector<std::size_t> nearest_of(const Grains& found, const Grains& truth, Vec2 corner) {
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::size_t best = 0;
    for (std::size_t j = 1; j < truth.size(); ++j)
      if (norm(truth.position[j] - corner - found.position[i]) <
          norm(truth.position[best] - corner - found.position[i]))
        best = j;
    nearest.push_back(best);
  }
  return nearest;
}

}  // namespace arenite::test
