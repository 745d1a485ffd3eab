#include "model/field_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/formula.hpp"
#include "core/mapped.hpp"

namespace arenite {
namespace {

/// The tensor with these principal values, the first along the angle `a`: R diag(first, second) R^T.
Tensor2 turned(double first, double second, double a) {
  const double c = std::cos(a), s = std::sin(a);
  return {first * c * c + second * s * s, (first - second) * c * s, (first - second) * c * s,
          first * s * s + second * c * c};
}

TEST(FieldQuantities, PrincipalStressesAreThoseThatATensorWasTurnedFrom) {
  const std::vector<double> angles{-1.5, -0.4, 0.0, 0.3, 1.2};
  const auto stresses = mapped(angles, [](double angle) { return turned(3e6, -1e6, angle); });
  const auto of = [&](const char* id) { return values_of(field_quantity(id), stresses); };
  const auto first = of("principal"), second = of("second"), angle = of("angle"), mean = of("hydrostatic");
  for (std::size_t k = 0; k < angles.size(); ++k) {
    EXPECT_NEAR(first[k], 3e6, 1e-8 * 3e6);
    EXPECT_NEAR(second[k], -1e6, 1e-8 * 3e6);
    EXPECT_NEAR(angle[k], angles[k] * 180 / std::numbers::pi, 1e-10);
    EXPECT_NEAR(mean[k], 1e6, 1e-8 * 1e6);  // whatever the angle
  }
}

TEST(FieldQuantities, OfNodesAreThoseOfTheirTensorAndDisplacement) {
  StressField field;
  field.width = 2, field.height = 1;
  const Tensor2 a = turned(2, -4, 0.5), b = turned(7, 1, -0.2);
  field.xx = {a.xx, b.xx}, field.yy = {a.yy, b.yy}, field.xy = {a.xy, b.xy};
  field.ux = {3, 0}, field.uy = {-4, 2};
  const auto of = [&](const char* name, std::size_t node) { return values_of(field_quantity(name), field)[node]; };
  EXPECT_NEAR(of("sigma_1", 0), 2, 1e-12);
  EXPECT_NEAR(of("sigma_2", 1), 1, 1e-12);
  EXPECT_EQ(of("sigma_yy", 1), b.yy);
  EXPECT_EQ(of("u", 0), 5);
  EXPECT_EQ(of("uy", 1), 2);
  EXPECT_THROW(field_quantity("sigma_zz"), InputError);
}

TEST(FieldQuantities, FormulasAreOfWhatIsStored) {
  for (const FieldQuantity& quantity : field_quantities())
    evaluated(quantity.formula, 1, [](std::string_view id) {
      EXPECT_TRUE(field_quantity(id).is_stored()) << id;
      return std::vector<double>{1};
    });
}

}  // namespace
}  // namespace arenite
