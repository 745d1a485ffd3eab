#include "thermal/imaging/registration_search.hpp"

#include "core/mapped.hpp"

namespace arenite::imaging {
namespace {

constexpr double reach_of_match = 0.3;  // of the smaller radius: two different grains cannot both be so near
constexpr double sharpest = 0.02;       // of a radius: what lies nearer than this is not told apart
constexpr double base_length = 10;      // mean radii: long enough to tell the direction, short enough to be whole
constexpr std::size_t most_bases = 60, test_grains = 12, agreeing_bases = 3;
constexpr double of_best[] = {0.75, 0.8, 0.85, 0.9};  // score of the best so far below which growing ends, stage by stage

}  // namespace

RegistrationSearch::RegistrationSearch(const PictureGrains& from, const PictureGrains& to, const RegistrationOptions& options)
    : from_(from),
      to_(to),
      options_(options),
      to_grid_(to) {}

RegistrationSearch::Pairs RegistrationSearch::best(Similarity& transform) {
  const std::size_t n = from_.size(), bases = std::min(n, most_bases);
  std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(n))), agreeing = 0;
  while (std::gcd(stride, n) != 1) ++stride;
  Candidate best;
  for (std::size_t k = 0; k < bases && agreeing < agreeing_bases; ++k) {
    const Similarity before = best.transform;
    const bool first = best.pairs.empty();
    try_base(k * stride % n, best);
    if (best.pairs.empty()) continue;
    agreeing = !first && same(before, best.transform) ? agreeing + 1 : 1;
  }
  transform = best.transform;
  return best.pairs;
}

RegistrationSearch::Pairs RegistrationSearch::matches(const Similarity& t, std::span<const std::int32_t> of) const {
  std::vector<std::pair<double, std::pair<std::int32_t, std::int32_t>>> all;
  for (const std::int32_t a : of) {
    const std::int32_t b = partner(t, a);
    if (b >= 0) all.push_back({norm(t(from_.centre[a]) - to_.centre[b]), {a, b}});
  }
  std::sort(all.begin(), all.end());
  std::vector<char> taken(to_.size(), 0);
  Pairs pairs;
  for (const auto& [distance, pair] : all)
    if (taken[static_cast<std::size_t>(pair.second)]++ == 0) pairs.push_back(pair);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Similarity RegistrationSearch::fit(const Pairs& pairs, bool mirrored) const {
  return fit_similarity(mapped(pairs, [&](const auto& pair) { return from_.centre[pair.first]; }),
                        mapped(pairs, [&](const auto& pair) { return to_.centre[pair.second]; }), mirrored);
}

std::vector<std::int32_t> RegistrationSearch::all() const {
  std::vector<std::int32_t> index(from_.size());
  std::iota(index.begin(), index.end(), 0);
  return index;
}

bool RegistrationSearch::alike(double scale, std::size_t a, std::size_t b) const {
  return options_.radius_within <= 0 || std::abs(std::log(scale * from_.radius[a] / to_.radius[b])) <= std::log1p(options_.radius_within);
}

std::int32_t RegistrationSearch::partner(const Similarity& t, std::int32_t a) const {
  const auto k = static_cast<std::size_t>(a);
  const Vec2 moved = t(from_.centre[k]);
  const std::int32_t b = to_grid_.nearest(moved, reach_of_match * t.scale * from_.radius[k]);
  if (b < 0) return -1;
  const auto at = static_cast<std::size_t>(b);
  if (!alike(t.scale, k, at) || norm(moved - to_.centre[at]) > reach_of_match * to_.radius[at]) return -1;
  return b;
}

/// Sum over pairs of how much nearer the two are than chance would have them (logarithm of the areas): in an ordered packing
/// a shift by one grain matches as many, but none of them well.
double RegistrationSearch::score(const Similarity& t, const Pairs& pairs) const {
  double sum = 0;
  for (const auto& [a, b] : pairs) {
    const double r = to_.radius[static_cast<std::size_t>(b)], off = norm(t(from_.centre[a]) - to_.centre[b]) / r;
    sum += std::log(reach_of_match * reach_of_match / (off * off + sharpest * sharpest));
  }
  return sum;
}

/// Whether two transforms bring the outermost grains to the same places.
bool RegistrationSearch::same(const Similarity& s, const Similarity& t) const {
  const double within = reach_of_match * mean_radius(to_);
  const geometry::Rectangle box = geometry::bounds(from_.centre);
  for (const Vec2 corner : {Vec2{box.x_min, box.y_min}, Vec2{box.x_max, box.y_min}, Vec2{box.x_min, box.y_max}, Vec2{box.x_max, box.y_max}})
    if (norm(s(corner) - t(corner)) > within) return false;
  return true;
}

/// All grains of `from`, the nearest to a place first.
std::vector<std::int32_t> RegistrationSearch::around(Vec2 middle) const {
  std::vector<std::int32_t> index = all();
  std::sort(index.begin(), index.end(), [&](std::int32_t a, std::int32_t b) {
    const Vec2 u = from_.centre[a] - middle, v = from_.centre[b] - middle;
    return std::pair(dot(u, u), a) < std::pair(dot(v, v), b);
  });
  return index;
}

/// The grain whose distance from `first` is nearest to the length of a base.
std::size_t RegistrationSearch::other_end(std::size_t first) const {
  const double wanted = base_length * mean_radius(from_);
  std::size_t best = first;
  double off = INFINITY;
  for (std::size_t k = 0; k < from_.size(); ++k) {
    const double away = norm(from_.centre[k] - from_.centre[first]);
    if (k == first || !(away > 0) || std::abs(away - wanted) >= off) continue;
    best = k;
    off = std::abs(away - wanted);
  }
  return best;
}

/// Scales that are looked at where a grain is held against another.
std::pair<double, double> RegistrationSearch::scales(std::size_t a, std::size_t b) const {
  if (options_.scale) return {*options_.scale * (1 - options_.scale_within), *options_.scale * (1 + options_.scale_within)};
  const double within = options_.radius_within > 0 ? 1 + options_.radius_within : 2, ratio = to_.radius[b] / from_.radius[a];
  return {ratio / within, ratio * within};
}

void RegistrationSearch::try_base(std::size_t a0, Candidate& best) const {
  const std::size_t a1 = other_end(a0);
  if (a1 == a0) return;
  const Vec2 ends[2] = {from_.centre[a0], from_.centre[a1]};
  const double length = norm(ends[1] - ends[0]);
  const std::vector<std::int32_t> order = around(0.5 * (ends[0] + ends[1]));
  best.score.clear();  // the best so far is to be beaten among the grains around this base, too
  for (const std::size_t reach : reaches())
    if (!best.pairs.empty()) best.score.push_back(score(best.transform, matches(best.transform, std::span(order).first(reach))));
  for (std::size_t b0 = 0; b0 < to_.size(); ++b0) {
    const auto [low, high] = scales(a0, b0);
    to_grid_.within(to_.centre[b0], high * length, [&, low = low](std::int32_t k, double square) {
      const auto b1 = static_cast<std::size_t>(k);
      const double scale = std::sqrt(square) / length;
      if (scale < low || scale == 0 || !alike(scale, a0, b0) || !alike(scale, a1, b1)) return;
      const Vec2 targets[2] = {to_.centre[b0], to_.centre[b1]};
      if (options_.mirror != Mirror::yes) grow(fit_similarity(ends, targets, false), order, best);
      if (options_.mirror != Mirror::no) grow(fit_similarity(ends, targets, true), order, best);
    });
  }
}

/// How many grains around its base a transform is held against, step by step.
std::vector<std::size_t> RegistrationSearch::reaches() const {
  std::vector<std::size_t> list{std::min(from_.size(), test_grains)};
  while (list.back() < from_.size()) list.push_back(std::min(from_.size(), 2 * list.back()));
  return list;
}

/// Holds a transform against the grains around its base and, while it keeps up with the best, fits it to twice as many.
void RegistrationSearch::grow(Similarity t, const std::vector<std::int32_t>& order, Candidate& best) const {
  const std::vector<std::size_t> stages = reaches();
  const std::size_t tests = stages.front(), allowed = (2 * tests) / 5;
  std::size_t failed = 0;
  for (std::size_t k = 0; k < tests && failed <= allowed; ++k)
    if (partner(t, order[k]) < 0) ++failed;
  if (failed > allowed) return;
  Candidate here;
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    for (int pass = 0; pass < 2; ++pass) {
      here.pairs = matches(t, std::span(order).first(stages[stage]));
      if (here.pairs.size() < 2) return;
      t = fit(here.pairs, t.mirrored);
    }
    here.score.push_back(score(t, here.pairs));
    if (stage < best.score.size() && here.score[stage] < of_best[std::min<std::size_t>(stage, 3)] * best.score[stage]) return;
  }
  if (here.total() <= best.total()) return;
  here.transform = t;
  best = std::move(here);
}

}  // namespace arenite::imaging
