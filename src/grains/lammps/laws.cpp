#include "grains/lammps/laws.hpp"

#include <fmt/core.h>

#include <cmath>
#include <variant>

#include "core/root.hpp"

namespace arenite::lammps {
namespace {

/// alpha of `damping tsuji` by the restitution it is told (Tsuji, Tanaka and Ishida 1992, as LAMMPS fits it).
double tsuji(double e) {
  return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/// The dashpots, of both directions: how the normal one follows, its number, and the sliding one over it.
struct Dashpots {
  std::string words;
  double number = 0, sliding = 1;
};

Dashpots dashpots_of(const dem::ContactParameters& contact) {
  if (!contact.normal_damping) {
    const double alpha = damping_over_root(contact);
    if (alpha <= 0) return {"velocity", 0, 1};
    return {"tsuji", tsuji_restitution(alpha), 1};
  }
  const double alpha = *contact.normal_damping, gamma = contact.sliding_viscosity.value_or(alpha);
  return {"velocity", alpha, alpha > 0 ? gamma / alpha : 1};
}

/// What slides, but for Coulomb's coefficient.
std::string sliding_words(const dem::ContactParameters& contact, const dem::Coefficients& c, double share) {
  if (contact.friction_law.is_none()) return "linear_nohistory 0";
  if (!std::holds_alternative<dem::CundallStrack>(contact.friction_law))
    return fmt::format("linear_nohistory {:.17g}", share);
  if (contact.takes_moduli())  // k_t = 8 G* sqrt(R* h), of which LAMMPS is told 8 G*
    return fmt::format("mindlin {:.17g} {:.17g}", 1.5 * c.shear * c.stiffness, share);
  return fmt::format("linear_history {:.17g} {:.17g}", contact.tangential_stiffness_ratio * c.stiffness, share);
}

/// `radius`: R* of all such contacts, where the law has k h sqrt(h/R*), which LAMMPS writes as K h sqrt(R* h).
std::string words(const dem::ContactParameters& contact, const dem::Coefficients& c, double radius, double friction) {
  const Dashpots dashpots = dashpots_of(contact);
  const double stiffness = std::holds_alternative<dem::Hertz>(contact.normal) ? c.stiffness / radius : c.stiffness;
  return fmt::format("{} {:.17g} {:.17g} damping {} tangential {} {:.17g}{}",
                     std::holds_alternative<dem::Linear>(contact.normal) ? "hooke" : "hertz", stiffness,
                     dashpots.number, dashpots.words, sliding_words(contact, c, dashpots.sliding),
                     contact.friction_law.is_none() ? 0 : friction, contact.attractive_dashpot ? "" : " limit_damping");
}

/// A grain of a material, of the radius at which a pair has 1/R* = 1 (a wall: R* = 1), so that a stiffness which
/// follows R* is that of unit radius.
template <int D> dem::GrainRecord<D> grain_of_material(int material, double radius) {
  dem::GrainRecord<D> grain;
  grain.radius = radius;
  grain.mass = 1;
  grain.material = material;
  return grain;
}

}  // namespace

double damping_over_root(const dem::ContactParameters& contact) {
  const double ratio = dem::damping_ratio(contact.restitution, contact.attractive_dashpot);
  return std::holds_alternative<dem::Linear>(contact.normal) ? ratio : std::sqrt(1.25) * ratio;
}

double tsuji_restitution(double alpha) {
  const auto excess = [&](double e) { return tsuji(e) - alpha; };
  return bracketed_root<double>(excess, 0, excess(0), 1.01, excess(1.01));
}

template <int D> std::string pair_words(const dem::SampleIn<D>& s, int a, int b) {
  const auto one = grain_of_material<D>(a, 2), other = grain_of_material<D>(b, 2);
  return words(s.contact, s.coefficients.pair(one, other, false), 0.5 * s.largest_radius, s.friction);
}

template <int D> std::string wall_words(const dem::SampleIn<D>& s, int material) {
  return words(s.contact, s.coefficients.wall(grain_of_material<D>(material, 1)), s.largest_radius, s.wall_friction);
}

template std::string pair_words(const dem::SampleIn<2>&, int, int);
template std::string pair_words(const dem::SampleIn<3>&, int, int);
template std::string wall_words(const dem::SampleIn<2>&, int);
template std::string wall_words(const dem::SampleIn<3>&, int);

}  // namespace arenite::lammps
