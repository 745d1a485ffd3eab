#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/root.hpp"
#include "geometry/meniscus.hpp"
#include "geometry/outline.hpp"
#include "geometry/union_area.hpp"
#include "model/cement.hpp"
#include "model/periodic_images.hpp"
#include "solid/cement/cement.hpp"

namespace arenite::cement {
namespace {

geometry::MeniscusDisks disks_of(const Packing& packing, geometry::Pair pair) {
  const Grains& g = packing.grains;
  const Vec2 d = packing.domain.nearest_image(g.position[pair.j] - g.position[pair.i]);
  return {g.radius[pair.i], g.radius[pair.j], norm(d)};
}

/// A disk inside another has no meniscus.
bool can_hold(const geometry::MeniscusDisks& d) { return d.distance > std::abs(d.radius_i - d.radius_j); }

/// Curvature of the arcs that enclose `volume`, which lies between what the largest curvature and straight arcs
/// enclose.
double curvature_of(const geometry::MeniscusDisks& d, double volume, double most) {
  // Curvature may be infinite at contact: x = c r / (1 + c r) runs from 0 to 1.
  const double r = std::min(d.radius_i, d.radius_j), largest = geometry::largest_meniscus_curvature(d);
  const double end = std::isinf(largest) ? 1 : largest * r / (1 + largest * r);
  const auto curvature = [&](double x) { return x < 1 ? x / ((1 - x) * r) : std::numeric_limits<double>::infinity(); };
  const auto excess = [&](double x) { return geometry::meniscus_area(d, curvature(x)) - volume; };
  return curvature(bracketed_root<double>(excess, 0, most - volume, end, excess(end)));
}

/// Bridges whose half bases are `half_width` times the radii of their grains (P II.B).
void add_bridges(const Packing& packing, const std::vector<geometry::Pair>& pairs, double half_width, Cement& cement) {
  const auto& r = packing.grains.radius;
  for (const auto [i, j] : pairs) cement.bridges.push_back({i, j, half_width * r[i], half_width * r[j]});
}

/// A meniscus of one volume (area, m^2) at every pair. Where it is less than the arcs enclose when they meet in the
/// middle of the gap there is none; where it is more than straight tangents enclose the arcs are straight.
void add_menisci(const Packing& packing, const std::vector<geometry::Pair>& pairs, double volume, Cement& cement,
                 CementReport& report) {
  for (const auto pair : pairs) {
    const geometry::MeniscusDisks disks = disks_of(packing, pair);
    if (!can_hold(disks)) continue;
    const double most = geometry::meniscus_area(disks, 0);
    if (volume <= geometry::meniscus_area(disks, geometry::largest_meniscus_curvature(disks))) {
      ++report.ruptured;
    } else if (volume >= most) {
      ++report.capped;
      cement.menisci.push_back({pair.i, pair.j, std::numeric_limits<double>::infinity()});
    } else {
      cement.menisci.push_back({pair.i, pair.j, 1 / curvature_of(disks, volume, most)});
    }
  }
}

/// The largest volume that a meniscus between two straight tangents holds at any pair, m^2.
double largest_meniscus_volume(const Packing& packing, const std::vector<geometry::Pair>& pairs) {
  double largest = 0;
  for (const auto pair : pairs) {
    const geometry::MeniscusDisks disks = disks_of(packing, pair);
    if (can_hold(disks)) largest = std::max(largest, geometry::meniscus_area(disks, 0));
  }
  return largest;
}

using Kind = CementParameters::Kind;

/// The widest bridge: its bases are as wide as the grains.
double widest(const CementParameters& p) { return p.full_width ? 2 : 1; }

void check(const CementParameters& p, const Window& w) {
  Problems problems;
  const auto length = [&](const char* what, double value) {
    problems.unless(value >= 0 && std::isfinite(value), "{} of {:g} is not a length; give at least 0", what, value);
  };
  const bool necks = p.kind == Kind::bridges || p.kind == Kind::menisci;
  if (necks) length("the cement's gap", p.gap.value_or(0));
  if (p.kind == Kind::bridges && !p.saturation)
    problems.unless(p.width >= 0 && p.width <= widest(p),
                    "a bridge's width of {:g} radii is out of range; give 0 to {:g}, as wide as the grain", p.width,
                    widest(p));
  if (p.kind == Kind::coating && !p.saturation) length("the coating's thickness", p.thickness);
  if (p.kind == Kind::menisci && !p.saturation) length("a meniscus' volume", p.volume);
  if (p.saturation) {
    const double s = *p.saturation;
    problems.unless(s > 0 && s <= 1, "a matrix saturation of {:g} is out of range; give more than 0, at most 1", s);
    problems.unless(p.kind != Kind::none && (p.kind != Kind::full || s == 1),
                    "{} cement has no saturation to prescribe; leave it out, or use bridges, coating or menisci",
                    p.kind == Kind::full ? "full" : "no");
  }
  problems.unless(w.width() > 0 && w.height() > 0 && std::isfinite(w.area()),
                  "the cement's window is {:g} x {:g} m; give it positive sides", w.width(), w.height());
  problems.raise();
}

/// One kind of cement with its one free parameter: width, thickness or volume.
class Maker {
 public:
  Maker(const Packing& packing, const CementParameters& p, const Window& window)
      : packing_(packing),
        p_(p),
        window_(window) {
    if (p.kind == Kind::bridges || p.kind == Kind::menisci)
      pairs_ = pairs_within(packing.grains, packing.domain, p.gap.value_or(0));
  }

  Cement operator()(double parameter, CementReport& report) const {
    Cement cement;
    report.parameter = parameter;
    if (p_.kind == Kind::full) cement.full = true;
    if (p_.kind == Kind::coating) cement.coating = parameter;
    if (p_.kind == Kind::bridges && parameter > 0)
      add_bridges(packing_, pairs_, p_.full_width ? 0.5 * parameter : parameter, cement);
    if (p_.kind == Kind::menisci && parameter > 0) add_menisci(packing_, pairs_, parameter, cement, report);
    report.necks = cement.bridges.size() + cement.menisci.size();
    report.areas = exact_areas(place(packing_, cement, window_), window_);
    report.saturation = report.areas.saturation();
    return cement;
  }

  double given() const {
    switch (p_.kind) {
      case Kind::bridges: return p_.width;
      case Kind::coating: return p_.thickness;
      case Kind::menisci: return p_.volume;
      default: return 0;
    }
  }

  /// A parameter that gives at least the saturation, or the one beyond which there is no more matrix to be had.
  template <class Excess> double high_enough(Excess&& excess) const {
    if (p_.kind == Kind::bridges) return widest(p_);
    if (p_.kind == Kind::menisci) return largest_meniscus_volume(packing_, pairs_);
    // Thick layers overlap each other many times, so a thickness is approached from below.
    const double most = std::hypot(window_.width(), window_.height());
    double thickness = 1e-3 * most / std::sqrt(static_cast<double>(packing_.grains.size() + 1));
    while (thickness < most && excess(thickness) < 0) thickness *= 2;
    return thickness;
  }

  double found(double saturation) const {
    const auto excess = [&](double parameter) {
      CementReport report;
      (*this)(parameter, report);
      return report.saturation - saturation;
    };
    const double high = high_enough(excess), most = excess(high);
    if (most < -1e-9)
      throw refusal(
          "a matrix saturation of {:g} cannot be reached: this cement fills more than 0, at most {:.4f}, of the space "
          "between grains; prescribe less, widen its gap, or use another kind",
          saturation, most + saturation);
    if (most <= 0) return high;
    return bracketed_root<double>(excess, 0, -saturation, high, most);
  }

 private:
  const Packing& packing_;
  const CementParameters& p_;
  const Window& window_;
  std::vector<geometry::Pair> pairs_;
};

}  // namespace

Areas exact_areas(const PlacedCement& placed, const Window& window) {
  using geometry::Outline;
  auto outlines = mapped(placed.grains, [](const auto& grain) { return Outline::disk(grain.centre, grain.radius); });
  const double particle = geometry::union_area(outlines, placed.window);
  if (placed.full) return {window.area(), particle, std::max(0.0, window.area() - particle)};
  if (placed.coating > 0)
    for (const auto& grain : placed.grains)
      outlines.push_back(Outline::disk(grain.centre, grain.radius + placed.coating));
  for (const auto& neck : placed.necks) {
    const auto of_neck = outlines_of(neck);
    outlines.insert(outlines.end(), of_neck.begin(), of_neck.end());
  }
  const double solid =
      outlines.size() == placed.grains.size() ? particle : geometry::union_area(outlines, placed.window);
  return {window.area(), particle, std::max(0.0, solid - particle)};
}

Cement make_cement(const Packing& packing, const CementParameters& parameters, const Window& window,
                   CementReport& report) {
  check(parameters, window);
  arenite::check(packing, {});
  const Maker make(packing, parameters, window);
  const bool choose = parameters.saturation && parameters.kind != Kind::full;
  report = {};
  Cement cement = make(choose ? make.found(*parameters.saturation) : make.given(), report);
  if (choose) report.saturation_error = report.saturation - *parameters.saturation;
  return cement;
}

}  // namespace arenite::cement
