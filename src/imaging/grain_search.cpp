#include "imaging/grain_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arenite::imaging {
namespace {

constexpr int most_rounds = 12;
constexpr double first_blur = 0.7;            // pixels
constexpr double overlap_of_candidates = 0.3; // of the smaller radius: centres are known to a pixel only
constexpr double least_explained = 0.75;      // of a disk's squares; the rest is noise, marks, neighbours that are not found yet
constexpr double rim_of_usual = 0.8;           // of the median disk's
constexpr double least_contrast = 0.2;        // of the usual contrast
constexpr double least_area = 0.005;          // share of all disks' area that a size needs

/// The search's state: the model, and for each disk the radius at which its rim was seen.
class Rounds {
 public:
  Rounds(const FloatImage& image, bool bright, const CircleOptions& options)
      : image_(image), bright_(bright), options_(options), model_(image, first_blur) {
    for (const double r : options.radii) {
      classes_.mean.push_back(r);
      classes_.spread.push_back(0.003 * r);
    }
    std::sort(classes_.mean.begin(), classes_.mean.end());
    std::sort(classes_.spread.begin(), classes_.spread.end());
  }

  /// The first round, on the picture as it is.
  void begin() {
    if (add(search_rims(image_, range(0)), 0) == 0) return;
    settle(10);
    settle(10);
  }

  /// Contrast squared times radius squared that the disks account for, summed.
  double gain() const {
    double sum = 0;
    const auto evidence = model_.evidence();
    for (std::size_t k = 0; k < evidence.size(); ++k) {
      const double size = evidence[k].contrast * model_.disks()[k].radius;
      sum += evidence[k].explained * size * size;
    }
    return sum;
  }

  void more_rounds() {
    for (int round = 1; round < most_rounds && !model_.disks().empty(); ++round) {
      const std::size_t before = model_.disks().size();
      if (add(search_rims(model_.residual(), range(round)), round) == 0) break;
      settle(10);
      settle(10);
      if (model_.disks().size() <= before) break;
    }
  }

  DiskSearch finish() {
    for (int pass = 0; pass < 3; ++pass) {
      more_rounds();
      model_.fit(20);
      const std::size_t before = model_.disks().size();
      prune(rim_of_usual);
      if (model_.disks().size() == before) break;
    }
    find_classes();
    return {std::move(model_), std::move(classes_), bright_};
  }

 private:
  RimOptions range(int round) const {
    RimOptions o;
    o.bright = bright_;
    const double largest = options_.largest > 0 ? options_.largest : 0.5 * std::min(image_.width, image_.height);
    o.smallest = classes_.size() > 0 ? 0.65 * classes_.mean.front() : 0.65 * options_.smallest;
    o.largest = classes_.size() > 0 ? 1.1 * classes_.mean.back() : largest;
    o.smallest = std::max(o.smallest, 1.2);
    o.least = round == 0 ? 0.15 : 0.2;
    return o;
  }

  /// How much smaller than the fitted radius a ring of this radius was seen, from the disks found so far.
  double inset(double ring) const {
    double sum = 0, weight = 1e-9;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const double w = std::exp(-std::abs(std::log(ring_[k] / ring)) / 0.1);
      sum += w * (model_.disks()[k].radius - ring_[k]);
      weight += w;
    }
    return sum / weight;
  }

  std::size_t nearest_class(double radius) const {
    std::size_t best = 0;
    for (std::size_t c = 1; c < classes_.size(); ++c)
      if (std::abs(std::log(radius / classes_.mean[c])) < std::abs(std::log(radius / classes_.mean[best]))) best = c;
    return best;
  }

  bool collides(double x, double y, double radius) const {
    for (const auto& disk : model_.disks()) {
      const double smaller = std::min(radius, disk.radius);
      if (std::hypot(x - disk.x, y - disk.y) < radius + disk.radius - overlap_of_candidates * smaller) return true;
    }
    return false;
  }

  /// A long rim that shows says more than a short one: marks on a grain and dirt are small.
  static double weight(const Circle& circle) { return circle.score * std::sqrt(std::sqrt(circle.radius)); }

  bool was_refused(const Circle& circle) const {
    return std::any_of(refused_.begin(), refused_.end(), [&](const Circle& r) {
      return std::hypot(r.x - circle.x, r.y - circle.y) < 0.4 * r.radius && std::abs(std::log(r.radius / circle.radius)) < 0.2;
    });
  }

  std::size_t add(std::vector<Circle> candidates, int round) {
    if (candidates.empty()) return 0;
    const double least = round == 0 ? 0.55 * candidates[std::min<std::size_t>(4, candidates.size() - 1)].score : 0.25;
    std::erase_if(candidates, [&](const Circle& circle) { return circle.score < least; });
    std::stable_sort(candidates.begin(), candidates.end(), [](const Circle& a, const Circle& b) { return weight(a) > weight(b); });
    std::size_t added = 0;
    for (Circle circle : candidates) {
      const double ring = circle.radius;
      if (classes_.size() > 0) {
        const double guess = ring + (ring_.empty() ? 0.0 : inset(ring));
        const double radius = classes_.mean[nearest_class(guess)];
        if (std::abs(std::log(guess / radius)) > (ring_.empty() ? 0.4 : 0.25)) continue;
        circle.radius = radius;
      }
      if (collides(circle.x, circle.y, circle.radius) || was_refused(circle)) continue;
      model_.add(circle);
      ring_.push_back(ring);
      ++added;
    }
    return added;
  }

  void settle(int sweeps) {
    set_priors();
    model_.refresh();
    model_.fit(sweeps);
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
      statistics::Clusters given{classes_.mean, classes_.spread, std::vector<std::size_t>(classes_.size(), 0), {}};
      for (const auto& disk : model_.disks()) {
        given.of.push_back(static_cast<std::int32_t>(nearest_class(disk.radius)));
        ++given.members[static_cast<std::size_t>(given.of.back())];
      }
      classes_ = std::move(given);
      return;
    }
    std::vector<double> logs;
    for (const auto& disk : model_.disks()) logs.push_back(std::log(disk.radius));
    const std::size_t few = std::max<std::size_t>(2, logs.size() / 50);
    classes_ = statistics::cluster(logs, {.most = 5, .separation = 4, .floor = 0.015, .least_members = few});
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      classes_.mean[c] = std::exp(classes_.mean[c]);
      classes_.spread[c] *= classes_.mean[c];
    }
  }

  /// Contrast of the median disk by area.
  static double usual_contrast(const std::vector<DiskModel::Disk>& disks, const std::vector<DiskModel::Evidence>& evidence) {
    std::vector<std::pair<double, double>> contrast_area;
    double area = 0;
    for (std::size_t k = 0; k < disks.size(); ++k) {
      contrast_area.emplace_back(std::abs(evidence[k].contrast), disks[k].radius * disks[k].radius);
      area += contrast_area.back().second;
    }
    std::sort(contrast_area.begin(), contrast_area.end());
    double below = 0;
    for (const auto& [contrast, part] : contrast_area)
      if ((below += part) >= 0.5 * area) return contrast;
    return 0;
  }

  /// Marks dirt and spots: a size that makes up next to nothing of the area found.
  void mark_specks(std::vector<char>& out) const {
    if (!options_.radii.empty()) return;
    const auto& disks = model_.disks();
    double area = 0;
    for (const auto& disk : disks) area += disk.radius * disk.radius;
    for (std::size_t k = 0; k < disks.size(); ++k) {
      double alike = 0;
      for (const auto& disk : disks)
        if (std::abs(std::log(disk.radius / disks[k].radius)) < 0.25) alike += disk.radius * disk.radius;
      if (alike < least_area * area) out[k] = 1;
    }
  }

  /// Takes out what the picture does not bear out: no contrast, little rim (also against the median's), not flat, or on top
  /// of a better disk.
  void prune(double of_usual = 0) {
    const auto evidence = model_.evidence();
    const auto& disks = model_.disks();
    std::vector<char> out(disks.size(), 0);
    mark_specks(out);
    const double usual = usual_contrast(disks, evidence);
    std::vector<double> rims;
    for (const auto& e : evidence) rims.push_back(e.rim);
    std::sort(rims.begin(), rims.end());
    const double least_rim = rims.empty() ? 0 : std::max(options_.least_score, of_usual * rims[rims.size() / 2]);
    for (std::size_t k = 0; k < disks.size(); ++k) {
      const auto& e = evidence[k];
      if (e.rim < least_rim || e.explained < least_explained || std::abs(e.contrast) < std::max(least_contrast * usual, 3 * model_.noise() / disks[k].radius)) out[k] = 1;
      if (options_.radii.empty() && disks[k].radius < 0.9 * options_.smallest) out[k] = 1;
    }
    for (std::size_t a = 0; a < disks.size(); ++a)
      for (std::size_t b = a + 1; b < disks.size(); ++b) {
        const double gap = std::hypot(disks[a].x - disks[b].x, disks[a].y - disks[b].y) - disks[a].radius - disks[b].radius;
        if (out[a] != 0 || out[b] != 0 || gap > -overlap_of_candidates * std::min(disks[a].radius, disks[b].radius)) continue;
        out[evidence[a].explained * evidence[a].rim < evidence[b].explained * evidence[b].rim ? a : b] = 1;
      }
    for (std::size_t k = 0; of_usual > 0 && k < out.size(); ++k)
      if (out[k] != 0) refused_.push_back({disks[k].x, disks[k].y, disks[k].radius, 0});
    model_.remove(out);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < out.size(); ++k)
      if (out[k] == 0) ring_[kept++] = ring_[k];
    ring_.resize(kept);
    model_.refresh();
  }

  const FloatImage& image_;
  bool bright_;
  const CircleOptions& options_;
  DiskModel model_;
  statistics::Clusters classes_;
  std::vector<double> ring_;
  std::vector<Circle> refused_;  ///< taken out at the end of a pass, so that others may take their place
};

}  // namespace

DiskSearch search_disks(const FloatImage& image, const CircleOptions& options) {
  Rounds bright(image, true, options), dark(image, false, options);
  if (options.contrast != GrainContrast::dark) bright.begin();
  if (options.contrast != GrainContrast::bright) dark.begin();
  return bright.gain() >= dark.gain() ? bright.finish() : dark.finish();
}

}  // namespace arenite::imaging
