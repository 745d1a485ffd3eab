#include "solid/voxels/stiffness_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/definite.hpp"

namespace arenite::voxels {

using statistics::described;

namespace {

Numbers both(const elasticity::BulkAndShear& moduli) {
  return {{"bulk", moduli.bulk}, {"shear", moduli.shear}, {"young", moduli.young()}};
}

}  // namespace

Numbers support_numbers(const statics::Support& s) {
  return {{"solid", described(s.solid, "", "Voxels that are not void")},
          {"carrying", described(s.carrying, "", "Of these, voxels that take part in carrying the load")},
          {"held_below", described(s.held_below, "", "Voxels connected to the lower clamp only, without stress")},
          {"held_above", described(s.held_above, "", "Voxels connected to the upper clamp only, without stress")},
          {"floating", described(s.floating, "", "Voxels connected to nothing that carries, without stress")},
          {"islands", described(s.islands, "", "Separate parts of these")}};
}

Numbers stiffness_numbers(const EffectiveStiffness& effective) {
  std::array<double, 36> stiffness{};
  const auto c = [&](std::size_t a, std::size_t b) -> double& { return stiffness[6 * a + b]; };
  Numbers rows = Numbers::list();
  double asymmetry = 0;
  for (std::size_t a = 0; a < 6; ++a) {
    Numbers row = Numbers::list();
    for (std::size_t b = 0; b < 6; ++b) {
      c(a, b) = (effective.stiffness[a][b] + effective.stiffness[b][a]) / 2;
      asymmetry = std::max(asymmetry, std::abs(effective.stiffness[a][b] - effective.stiffness[b][a]));
      row.push_back(effective.stiffness[a][b]);
    }
    rows.push_back(std::move(row));
  }
  const double axial = c(0, 0) + c(1, 1) + c(2, 2), cross = c(0, 1) + c(1, 2) + c(0, 2),
               shear = c(3, 3) + c(4, 4) + c(5, 5);
  const elasticity::BulkAndShear mean{(axial + 2 * cross) / 9, (axial - cross + 3 * shear) / 15};
  Numbers j{{"stiffness_Pa", described(std::move(rows), "Pa",
                                       "Stiffness of the periodic sample, Voigt's order xx, yy, zz, yz, xz, xy")},
            {"asymmetry", described(asymmetry / (axial / 3), "",
                                    "Largest difference between a row and its column over the mean axial stiffness")}};
  const auto compliance = inverse_of_definite<6>(stiffness);
  const auto s = [&](std::size_t a, std::size_t b) { return compliance[6 * a + b]; };
  const bool carries = std::ranges::all_of(compliance, [](double v) { return std::isfinite(v); }) && c(0, 0) > 0 &&
                       1 / s(0, 0) > 1e-9 * c(0, 0);
  if (carries) {
    j["young_Pa"] = described({1 / s(0, 0), 1 / s(1, 1), 1 / s(2, 2)}, "Pa", "Young's modulus along x, y, z");
    j["shear_Pa"] = described({1 / s(3, 3), 1 / s(4, 4), 1 / s(5, 5)}, "Pa", "Shear modulus in yz, xz, xy");
    j["poisson"] = described({-s(0, 1) / s(0, 0), -s(1, 2) / s(1, 1), -s(2, 0) / s(2, 2)}, "",
                             "Poisson's ratio: contraction along y, z, x as the sample is pulled along x, y, z");
  }
  j["isotropic_mean_Pa"] = described(both(mean), "Pa", "Modulus of the isotropic stiffness nearest to it");
  j["anisotropy"] = described(2 * shear / (axial - cross), "", "Mean shear modulus over (C11 - C12)/2; 1: isotropic");
  j["bounds_Pa"] = described({{"voigt", both(effective.bounds.voigt)},
                              {"hashin_shtrikman_upper", both(effective.bounds.shtrikman_upper)},
                              {"hashin_shtrikman_lower", both(effective.bounds.shtrikman_lower)},
                              {"reuss", both(effective.bounds.reuss)}},
                             "Pa", "Bound of the modulus by what fills the voxels");
  j["voxels"] = support_numbers(effective.support);
  int iterations = 0;
  for (const auto& solve : effective.solves) iterations = std::max(iterations, solve.iterations);
  j["iterations"] = described(iterations, "", "Most iterations of the six solves");
  return j;
}

}  // namespace arenite::voxels
