#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "thermal/imaging/blur.hpp"
#include "thermal/imaging/disk_evidence.hpp"
#include "thermal/imaging/disk_model.hpp"
#include "thermal/imaging/rim_search.hpp"

namespace arenite::imaging {

/// Disks of a picture, and what is known of them all: classes of size are those of the model's disks, materials are not
/// known yet.
struct DiskSearch {
  DiskModel model;
  CircleReport report;
};

/// The search for the disks of a picture, round by round: candidates from rims are fitted together, what the picture
/// does not bear out is taken out, and the rest of the picture is searched anew. Picture and options must outlive it.
class SearchRounds {
 public:
  /// Where rims are looked for: the sizes that are known, or all that the picture can hold.
  static RimOptions range(const FloatImage& image, const CircleOptions& options, const std::vector<double>& sizes,
                          bool bright, double least) {
    const double smallest = sizes.empty() ? options.smallest : *std::min_element(sizes.begin(), sizes.end());
    const double largest = options.largest > 0 ? options.largest : 0.5 * std::min(image.width, image.height);
    return {.bright = bright,
            .smallest = std::max(0.65 * smallest, 1.2),
            .largest = sizes.empty() ? largest : 1.1 * *std::max_element(sizes.begin(), sizes.end()),
            .least = least};
  }

  /// `between`: level of the background, where disks may be brighter and darker.
  SearchRounds(const FloatImage& image, bool bright, const CircleOptions& options,
               std::optional<double> between = std::nullopt)
      : image_(image),
        bright_(bright),
        options_(options),
        between_(between),
        model_(image, first_blur, bright, between) {
    classes_.mean = options.radii;
    std::ranges::sort(classes_.mean);
    classes_.spread = mapped(classes_.mean, [](double r) { return 0.003 * r; });
  }

  /// The first round, with the rims that the picture shows as it is: of both signs where there is a level between.
  void begin(std::vector<Circle> seen) {
    if (add(std::move(seen), 0) == 0) return;
    settle(10);
    settle(10);
  }

  /// Contrast squared times radius squared that the disks account for, summed.
  double gain() const {
    return explained([](double radius, double contrast) { return square(contrast * radius); });
  }

  /// Pixels of the disks that are explained.
  double area() const {
    return std::numbers::pi * explained([](double radius, double) { return square(radius); });
  }

  /// All further rounds, until nothing is left; the result, once.
  DiskSearch finish() {
    std::vector<DiskModel::Disk> last;
    for (int pass = 0; pass < most_passes; ++pass) {
      more_rounds();
      model_.fit(20);
      const std::size_t before = model_.disks().size();
      prune(true);
      if (model_.disks().size() == before) break;
      if (pass > 0 && found_nothing_since(last)) break;
      last = model_.disks();
    }
    find_classes();
    const double blur = model_.blur(), noise = model_.noise();
    return {std::move(model_),
            {.bright = bright_, .between = between_, .blur = blur, .noise = noise, .sizes = std::move(classes_)}};
  }

 private:
  static constexpr int most_rounds = 24,
                       most_passes = 8;      // rounds of all passes together: a picture of grains takes a handful
  static constexpr double first_blur = 0.7;  // pixels
  static constexpr double overlap_of_candidates =
      0.45;  // of the smaller radius: centres are known to a pixel only, and the
             // neighbours of a disk that is not found yet are drawn towards it

  static double square(double v) { return v * v; }

  /// Centres of two disks that are nearer are not both believed.
  static double least_distance(double a, double b) { return a + b - overlap_of_candidates * std::min(a, b); }

  /// A long rim that shows says more than a short one: marks on a grain and dirt are small.
  static double weight(const Circle& circle) { return circle.score * std::sqrt(std::sqrt(circle.radius)); }

  /// Sum over the disks of what they explain of `of` their radius and contrast.
  template <class Of> double explained(const Of& of) const {
    double sum = 0;
    const auto evidence = model_.evidence();
    for (std::size_t k = 0; k < evidence.size(); ++k)
      sum += evidence[k].explained * of(model_.disks()[k].radius, evidence[k].contrast);
    return sum;
  }

  void more_rounds() {
    for (; rounds_ < most_rounds && !model_.disks().empty(); ++rounds_) {
      const std::size_t before = model_.disks().size();
      if (add(candidates(), rounds_ + 1) == 0) break;
      settle(10);
      settle(5);
      if (model_.disks().size() <= before) break;
    }
  }

  /// The disks of the pass before, each where it was, and no others: what the pass had added did not last.
  bool found_nothing_since(const std::vector<DiskModel::Disk>& last) const {
    return std::ranges::equal(model_.disks(), last,
                              [](const auto& a, const auto& b) { return norm(a.centre - b.centre) < 0.5; });
  }

  /// Pixels where a further centre would not collide with the disks found so far.
  Mask open_pixels(double smallest) const {
    Mask open{image_.width, image_.height, std::vector<char>(image_.size(), 1)};
    const double radius = classes_.size() > 0 ? classes_.mean.front() : smallest;
    for (const auto& disk : model_.disks()) {
      const double away = least_distance(radius, disk.radius);
      each_pixel_near(disk.centre, away, image_.width, image_.height, [&](int x, int y, std::size_t at) {
        if (square(x - disk.centre.x) + square(y - disk.centre.y) < square(away)) open.value[at] = 0;
      });
    }
    return open;
  }

  std::vector<Circle> candidates() const {
    RimOptions how = range(image_, options_, classes_.mean, bright_, 0.2);
    if (options_.radii.empty()) how.smallest = std::max(how.smallest, least_resolved(model_));
    const Mask open = open_pixels(how.smallest);
    how.open = &open;
    const FloatImage rest = model_.residual();
    std::vector<Circle> seen = search_rims(rest, how);
    if (between_) {
      how.bright = !how.bright;
      const std::vector<Circle> dark = search_rims(rest, how);
      seen.insert(seen.end(), dark.begin(), dark.end());
    }
    return seen;
  }

  /// How much smaller than the fitted radius a ring of this radius was seen, from the disks found so far.
  double inset(double ring) const {
    double sum = 0, weight = 1e-9;
    for (const auto& disk : model_.disks()) {
      const double w = std::exp(-std::abs(std::log(disk.ring / ring)) / 0.1);
      sum += w * (disk.radius - disk.ring);
      weight += w;
    }
    return sum / weight;
  }

  std::size_t nearest_class(double radius) const {
    const auto off = mapped(classes_.mean, [&](double mean) { return std::abs(std::log(radius / mean)); });
    return static_cast<std::size_t>(std::ranges::min_element(off) - off.begin());
  }

  bool collides(const Circle& circle) const {
    return std::ranges::any_of(model_.disks(), [&](const auto& disk) {
      const Vec2 apart = circle.centre - disk.centre;
      return dot(apart, apart) < square(least_distance(circle.radius, disk.radius));
    });
  }

  bool was_refused(const Circle& circle) const {
    return std::ranges::any_of(refused_, [&](const Circle& r) {
      return norm(r.centre - circle.centre) < 0.4 * r.radius && std::abs(std::log(r.radius / circle.radius)) < 0.2;
    });
  }

  std::size_t add(std::vector<Circle> candidates, int round) {
    if (candidates.empty()) return 0;
    const double least = round == 0 ? 0.55 * candidates[std::min<std::size_t>(4, candidates.size() - 1)].score : 0.25;
    std::erase_if(candidates, [&](const Circle& circle) { return circle.score < least; });
    std::ranges::stable_sort(candidates, std::greater{}, weight);
    std::size_t added = 0;
    for (Circle circle : candidates) {
      const double ring = circle.radius;
      if (classes_.size() > 0) {
        const double guess = ring + (model_.disks().empty() ? 0.0 : inset(ring));
        const double radius = classes_.mean[nearest_class(guess)];
        if (std::abs(std::log(guess / radius)) > (model_.disks().empty() ? 0.4 : 0.25)) continue;
        circle.radius = radius;
      }
      if (collides(circle) || was_refused(circle)) continue;
      model_.add(circle);
      model_.disks().back().ring = ring;
      ++added;
    }
    return added;
  }

  void settle(int sweeps) {
    set_priors();
    model_.refresh();
    model_.fit(sweeps, 5);
    prune();
    find_classes();
  }

  void set_priors() {
    for (auto& disk : model_.disks()) {
      disk.prior_error = 0;
      if (classes_.size() == 0) continue;
      const std::size_t c = nearest_class(disk.radius);
      disk.prior_radius = classes_.mean[c];
      disk.prior_error = classes_.spread[c];
    }
  }

  void find_classes() {
    if (!options_.radii.empty()) {
      classes_.of = mapped<std::int32_t>(
          model_.disks(), [&](const auto& disk) { return static_cast<std::int32_t>(nearest_class(disk.radius)); });
      classes_.members.assign(classes_.size(), 0);
      for (const std::int32_t c : classes_.of) ++classes_.members[static_cast<std::size_t>(c)];
      return;
    }
    const auto logs = mapped(model_.disks(), [](const auto& disk) { return std::log(disk.radius); });
    const std::size_t few = logs.size() < 10 ? 1 : std::max<std::size_t>(2, logs.size() / 50);
    classes_ = statistics::cluster(logs, {.most = 5, .separation = 4, .floor = 0.015, .least_members = few});
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      classes_.mean[c] = std::exp(classes_.mean[c]);
      classes_.spread[c] *= classes_.mean[c];
    }
  }

  void prune(bool strict = false) {
    const std::vector<char> out = refuted_disks(model_, options_, strict);
    const auto& disks = model_.disks();
    for (std::size_t k = 0; strict && k < out.size(); ++k)
      if (out[k] != 0) refused_.push_back({disks[k].centre, disks[k].radius, 0});
    model_.remove(out);
    model_.refresh();
  }

  const FloatImage& image_;
  bool bright_;
  const CircleOptions& options_;
  std::optional<double> between_;
  DiskModel model_;
  statistics::Clusters classes_;
  int rounds_ = 0;               ///< done after the first
  std::vector<Circle> refused_;  ///< taken out at the end of a pass, so that others may take their place
};

}  // namespace arenite::imaging
