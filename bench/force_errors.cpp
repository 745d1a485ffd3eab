#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>

#include "../tests/support/pressed_crystal.hpp"
#include "../tests/support/thermoelastic_picture.hpp"
#include "io/results/results.hpp"
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/pixel_forces.hpp"

/// force_errors LOW.h5 HIGH.h5: draws the difference of two simulated states as a film would show it, with every source
/// of error, then with one switched off at a time, and prints what the inferred forces are off by.
namespace {

using namespace arenite;

struct Sources {
  test::ThermoelasticDrawing drawing;
  double position = 0.1;       ///< standard error of centres, pixels
  double offered = 0.2;        ///< pairs with smaller gaps are offered as contacts, pixels
  double assumed_blur = 0.55;  ///< pixels
  double wall = 0.005;         ///< error of the load on the lower wall, share
  bool rolling = true;         ///< contacts have another direction in the low state
  Sources() { drawing.traction = elasticity::Traction::elliptic, drawing.half_angle = 0.1; }
};

using Pair = std::pair<int, int>;

/// The high state with the forces' differences; contacts that only the low state has are added.
Packing difference(const Packing& low, const Packing& high) {
  Packing change = high;
  std::map<Pair, std::size_t> at;
  for (std::size_t c = 0; c < high.contacts.size(); ++c) at[{high.contacts.i[c], high.contacts.j[c]}] = c;
  for (std::size_t c = 0; c < low.contacts.size(); ++c) {
    const auto i = low.contacts.i[c], j = low.contacts.j[c];
    if (const auto it = at.find({i, j}); it != at.end()) {
      change.contacts.fn[it->second] -= low.contacts.fn[c], change.contacts.ft[it->second] -= low.contacts.ft[c];
      continue;
    }
    Vec2 n = low.contacts.normal[c];
    if (j >= 0)
      n = high.grains.position[static_cast<std::size_t>(i)] - high.grains.position[static_cast<std::size_t>(j)];
    change.contacts.add(i, j, (1 / norm(n)) * n, -low.contacts.fn[c], -low.contacts.ft[c], low.contacts.arm_i[c],
                        low.contacts.arm_j[c]);
  }
  return change;
}

void offer(Packing& found, double gap) {
  std::map<Pair, bool> known;
  for (std::size_t c = 0; c < found.contacts.size(); ++c)
    known[std::minmax(found.contacts.i[c], found.contacts.j[c])] = true;
  const auto n = static_cast<int>(found.grains.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Vec2 d = found.grains.position[a] - found.grains.position[b];
      if (norm(d) - found.grains.radius[a] - found.grains.radius[b] < gap && !known.count({i, j}))
        found.contacts.add(i, j, (1 / norm(d)) * d, 0, 0, found.grains.radius[a], found.grains.radius[b]);
    }
}

void report(const char* name, const Packing& low, const Packing& high, const Sources& s) {
  const Packing truth = difference(low, high);
  const std::vector<double> factor = test::factors(truth);
  inference::ThermoelasticPicture picture = test::draw_thermoelastic(s.rolling ? high : truth, factor, s.drawing);
  if (s.rolling) {  // fields of both states, in the frame of their grains
    Packing before = low;
    before.grains = high.grains;
    test::ThermoelasticDrawing clean = s.drawing;
    clean.noise = 0;
    const inference::ThermoelasticPicture first = test::draw_thermoelastic(before, factor, clean);
    for (std::size_t k = 0; k < picture.value.size(); ++k) picture.value[k] -= first.value[k];
  }
  picture.error.assign(picture.value.size(), static_cast<float>(std::max(s.drawing.noise, 1e-4)));
  Packing found = truth;
  RandomStream random(7, Purpose::test);
  for (std::size_t g = 0; g < found.grains.size(); ++g) {
    found.grains.position[g].x += s.position * s.drawing.pixel * random.normal();
    found.grains.position[g].y += s.position * s.drawing.pixel * random.normal();
  }
  offer(found, s.offered * s.drawing.pixel);
  double load = 0, mean = 0;
  for (std::size_t c = 0; c < truth.contacts.size(); ++c) {
    if (truth.contacts.is_wall(c) && truth.contacts.wall_side(c) == bottom) load += truth.contacts.fn[c];
    mean += truth.contacts.fn[c] / static_cast<double>(truth.contacts.size());
  }
  inference::ForceOptions options;
  options.blur = s.assumed_blur;
  const InferredForces f = inference::infer_from_pixels(
      {test::without_forces(found), factor, {{bottom, (1 + s.wall) * load, 0.005 * load}}}, picture, options);
  Packing given = truth;  // offered contacts carry nothing
  given.contacts.fn.resize(f.contacts.size()), given.contacts.ft.resize(f.contacts.size());
  double above = 0, found_above = 0, kept = 0, score = 0;
  for (std::size_t c = 0; c < f.contacts.size(); ++c) {
    score +=
        std::pow((f.contacts.fn[c] - given.contacts.fn[c]) / f.fn_error[c], 2) / static_cast<double>(f.contacts.size());
    if (c >= truth.contacts.size()) kept += f.present[c];
    else above += given.contacts.fn[c] > mean, found_above += f.contacts.fn[c] > mean;
  }
  const auto real = static_cast<double>(truth.contacts.size()), offered = static_cast<double>(f.contacts.size()) - real;
  std::printf("| %s | %.2f | %.2f | %+.3f | %.1f | %.0f of %.0f |\n", name,
              100 * test::relative_error(f.contacts.fn, given.contacts.fn),
              100 * test::relative_error(f.contacts.ft, given.contacts.ft), (found_above - above) / real,
              std::sqrt(score), kept, offered);
}

int run(const char* low_file, const char* high_file) {
  const Packing low = io::read_stage(low_file).snapshots.back().packing,
                high = io::read_stage(high_file).snapshots.back().packing;
  std::printf("%zu grains, %zu contacts\n", high.grains.size(), high.contacts.size());
  std::printf(
      "| source | fn, %% | ft, %% | share above the mean | error over standard error | spurious kept "
      "|\n|---|---|---|---|---|---|\n");
  const auto with = [&](const char* name, const std::function<void(Sources&)>& change) {
    Sources s;
    change(s);
    report(name, low, high, s);
  };
  with("all", [](Sources&) {});
  with("no noise", [](Sources& s) { s.drawing.noise = 0; });
  with("centres exact", [](Sources& s) { s.position = 0; });
  with("lens known", [](Sources& s) { s.assumed_blur = 0.5; });
  with("forces in points", [](Sources& s) { s.drawing.traction = elasticity::Traction::point; });
  with("contacts do not roll", [](Sources& s) { s.rolling = false; });
  with("wall load exact", [](Sources& s) { s.wall = 0; });
  with("no contact too many", [](Sources& s) { s.offered = -10; });
  with("none", [](Sources& s) {
    s.drawing.noise = 0, s.position = 0, s.assumed_blur = 0.5, s.drawing.traction = elasticity::Traction::point;
    s.rolling = false, s.wall = 0, s.offered = -10;
  });
  with("all, 1 mK instead of 0.3", [](Sources& s) { s.drawing.noise = 1e-3; });
  with("all, centres 0.2 px instead of 0.1", [](Sources& s) { s.position = 0.2; });
  with("all, arcs twice as wide", [](Sources& s) { s.drawing.half_angle = 0.2; });
  with("all, lens 0.6 px taken for 0.5", [](Sources& s) { s.assumed_blur = 0.6; });
  with("all, pixel 2.4 mm", [](Sources& s) { s.drawing.pixel = 2.4e-3; });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3)
    return std::fprintf(stderr, "force_errors LOW.h5 HIGH.h5: stage files of the smallest and the largest load\n"), 2;
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception& e) { return std::fprintf(stderr, "%s\n", e.what()), 2; }
}
