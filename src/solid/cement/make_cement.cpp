#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "solid/cement/cement.hpp"
#include "solid/cement/joints.hpp"
#include "core/bracketed_root.hpp"
#include "core/error.hpp"
#include "model/placed_cement.hpp"

namespace arenite::cement {
namespace {

using Kind = CementParameters::Kind;

/// The widest bridge: its bases are as wide as the grains.
double widest(const CementParameters& p) { return p.full_width ? 2 : 1; }

void check(const CementParameters& p, const Window& w) {
  std::vector<Problem> problems;
  const auto report = [&](std::string message) { problems.push_back({{}, 0, 0, std::move(message)}); };
  const auto length = [&](const char* what, double value) {
    if (!(value >= 0) || !std::isfinite(value)) report(fmt::format("{} of {:g} is no length; give at least 0", what, value));
  };
  const bool joints = p.kind == Kind::bridges || p.kind == Kind::menisci;
  if (joints) length("the cement's gap", p.gap);
  if (p.kind == Kind::bridges && !p.saturation && !(p.width >= 0 && p.width <= widest(p)))
    report(fmt::format("a bridge's width of {:g} radii is out of range; give 0 to {:g}, as wide as the grain", p.width,
                       widest(p)));
  if (p.kind == Kind::coating && !p.saturation) length("the coating's thickness", p.thickness);
  if (p.kind == Kind::menisci && !p.saturation) length("a meniscus' volume", p.volume);
  if (p.saturation && !(*p.saturation > 0 && *p.saturation <= 1))
    report(fmt::format("a matrix saturation of {:g} is out of range; give more than 0, at most 1", *p.saturation));
  if (p.saturation && (p.kind == Kind::none || (p.kind == Kind::full && *p.saturation != 1)))
    report(fmt::format("{} cement has no saturation to choose; leave it out or take bridges, coating or menisci",
                       p.kind == Kind::full ? "full" : "no"));
  if (!(w.width() > 0 && w.height() > 0) || !std::isfinite(w.area()))
    report(fmt::format("the cement's window is {:g} x {:g} m; give it positive sides", w.width(), w.height()));
  if (!problems.empty()) throw InputError(std::move(problems));
}

/// One kind of cement with its one free parameter: width, thickness or volume.
class Maker {
 public:
  Maker(const Packing& packing, const CementParameters& p, const Window& window)
      : packing_(packing), p_(p), window_(window) {
    if (p.kind == Kind::bridges || p.kind == Kind::menisci) pairs_ = joined_pairs(packing, p.gap);
  }

  Cement operator()(double parameter, CementReport& report) const {
    Cement cement;
    report.parameter = parameter;
    if (p_.kind == Kind::full) cement.full = true;
    if (p_.kind == Kind::coating) cement.coating = parameter;
    if (p_.kind == Kind::bridges && parameter > 0)
      cement.bridges = make_bridges(packing_, pairs_, p_.full_width ? 0.5 * parameter : parameter);
    if (p_.kind == Kind::menisci) {
      Menisci made = make_menisci(packing_, pairs_, parameter);
      cement.menisci = std::move(made.menisci);
      report.ruptured = made.ruptured;
      report.capped = made.capped;
    }
    report.joints = cement.bridges.size() + cement.menisci.size();
    report.areas = exact_areas(packing_, cement, window_);
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
  template <class Excess>
  double high_enough(Excess&& excess) const {
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
      throw InputError(fmt::format(
          "a matrix saturation of {:g} cannot be reached: this cement fills more than 0, at most {:.4f}, of the space between "
          "grains; ask for less, widen its gap, or take another kind",
          saturation, most + saturation));
    if (most <= 0) return high;
    return bracketed_root(excess, 0, -saturation, high, most, 1e-13 * high, 1e-9);
  }

 private:
  const Packing& packing_;
  const CementParameters& p_;
  const Window& window_;
  std::vector<geometry::Pair> pairs_;
};

}  // namespace

Cement make_cement(const Packing& packing, const CementParameters& parameters, const Window& window, CementReport& report) {
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
