#include "solid/elements/stiffness_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/definite.hpp"

namespace arenite::elements {

using statistics::described;

namespace {

template <int D> Numbers all_of(const elasticity::BulkAndShear<D>& moduli) {
  return {{"bulk", moduli.bulk}, {"shear", moduli.shear}, {"young", moduli.young()}};
}

/// The isotropic stiffness nearest to one, and how far its shear is from what isotropy asks.
template <int D> struct Isotropic {
  elasticity::BulkAndShear<D> moduli;
  double anisotropy;  ///< mean shear modulus over (C11 - C12)/2
};
template <int D, class Stiffness> Isotropic<D> isotropic_part(const Stiffness& c) {
  double axial = 0, cross = 0, shear = 0;
  for (std::size_t a = 0; a < D; ++a) {
    axial += c(a, a);
    for (std::size_t b = a + 1; b < D; ++b) cross += c(a, b);
  }
  for (std::size_t k = D; k < voigt_count<D>; ++k) shear += c(k, k);
  constexpr int planes = D * (D - 1) / 2;
  const double in_planes = ((D - 1) * axial - 2 * cross) / (D * (D - 1)) / 2;  // mean of (C11 - C12)/2
  const double sheared = shear / planes;
  // The strains that change no volume: D - 1 of normal components, `planes` of shear.
  return {{(axial + 2 * cross) / (D * D), ((D - 1) * in_planes + planes * sheared) / (D - 1 + planes)},
          sheared / in_planes};
}

template <int D> Numbers moduli_along_axes(const std::array<double, voigt_count<D> * voigt_count<D>>& compliance) {
  constexpr std::size_t n = voigt_count<D>;
  const auto s = [&](std::size_t a, std::size_t b) { return compliance[n * a + b]; };
  Numbers young = Numbers::list(), shear = Numbers::list(), poisson = Numbers::list();
  for (std::size_t a = 0; a < D; ++a) {
    young.push_back(1 / s(a, a));
    poisson.push_back(-s((a + 1) % D, a) / s(a, a));
  }
  for (std::size_t k = D; k < n; ++k) shear.push_back(1 / s(k, k));
  return {{"young_Pa",
           described(std::move(young), "Pa", D == 2 ? "Young's modulus along x, y" : "Young's modulus along x, y, z")},
          {"shear_Pa",
           described(std::move(shear), "Pa", D == 2 ? "Shear modulus of the plane" : "Shear modulus in yz, xz and xy")},
          {"poisson", described(std::move(poisson), "",
                                D == 2 ? "Poisson's ratio: contraction along y, x as the sample is pulled along x, y"
                                       : "Poisson's ratio: contraction along y, z, x as the sample is pulled along x, "
                                         "y, z")}};
}

}  // namespace

Numbers support_numbers(const statics::Support& s) {
  return {{"solid", described(s.solid, "", "Elements that are not void")},
          {"carrying", described(s.carrying, "", "Of these, elements that take part in carrying the load")},
          {"held_below", described(s.held_below, "", "Elements connected to the lower clamp only, without stress")},
          {"held_above", described(s.held_above, "", "Elements connected to the upper clamp only, without stress")},
          {"floating", described(s.floating, "", "Elements connected to nothing that carries, without stress")},
          {"islands", described(s.islands, "", "Separate parts of these")}};
}

constexpr double least_share = 1e-9;  // of the largest stiffness: what is less is rounding

template <int D> Numbers stiffness_numbers(const EffectiveStiffness<D>& effective) {
  constexpr std::size_t n = voigt_count<D>;
  std::array<double, n * n> symmetric{};
  const auto c = [&](std::size_t a, std::size_t b) { return symmetric[n * a + b]; };
  Numbers rows = Numbers::list();
  double asymmetry = 0;
  for (std::size_t a = 0; a < n; ++a) {
    Numbers row = Numbers::list();
    for (std::size_t b = 0; b < n; ++b) {
      symmetric[n * a + b] = (effective.stiffness[a][b] + effective.stiffness[b][a]) / 2;
      asymmetry = std::max(asymmetry, std::abs(effective.stiffness[a][b] - effective.stiffness[b][a]));
      row.push_back(effective.stiffness[a][b]);
    }
    rows.push_back(std::move(row));
  }
  double axial = 0;
  for (std::size_t a = 0; a < D; ++a) axial += c(a, a) / D;
  Numbers j{
      {"stiffness_Pa", described(std::move(rows), "Pa",
                                 D == 2 ? "Stiffness of the periodic sample, Voigt's order xx, yy, xy"
                                        : "Stiffness of the periodic sample, Voigt's order xx, yy, zz, yz, xz, xy")},
      {"asymmetry", described(asymmetry / axial, "",
                              "Largest difference between a row and its column over the mean axial stiffness")}};
  const auto compliance = inverse_of_definite<n>(symmetric);
  double largest = 0;
  for (std::size_t a = 0; a < n; ++a) largest = std::max(largest, c(a, a));
  bool carries = largest > 0;
  for (std::size_t a = 0; a < n; ++a) carries &= 1 / compliance[n * a + a] > least_share * largest;  // false of a NaN
  if (carries) j.update(moduli_along_axes<D>(compliance));
  else
    j["notes"].push_back(
        "The sample, as a period, gives way to some strain without stress, so that it has no moduli; its stiffness "
        "tells along which axes it carries.");
  const Isotropic<D> isotropic = isotropic_part<D>(c);
  j["isotropic_mean_Pa"] =
      described(all_of(isotropic.moduli), "Pa", "Modulus of the isotropic stiffness nearest to it");
  j["anisotropy"] = described(isotropic.anisotropy, "", "Mean shear modulus over (C11 - C12)/2; 1: isotropic");
  j["bounds_Pa"] = described({{"voigt", all_of(effective.bounds.voigt)},
                              {"hashin_shtrikman_upper", all_of(effective.bounds.shtrikman_upper)},
                              {"hashin_shtrikman_lower", all_of(effective.bounds.shtrikman_lower)},
                              {"reuss", all_of(effective.bounds.reuss)}},
                             "Pa", "Bound of the modulus by what fills the sample");
  j["elements"] = support_numbers(effective.support);
  int iterations = 0;
  for (const auto& solve : effective.solves) iterations = std::max(iterations, solve.iterations);
  j["iterations"] = described(iterations, "", "Most iterations of a solve");
  return j;
}

template Numbers stiffness_numbers(const EffectiveStiffness<2>& effective);
template Numbers stiffness_numbers(const EffectiveStiffness<3>& effective);

}  // namespace arenite::elements
