#pragma once
#include <cstddef>
#include <optional>

#include "grains/fields/test_curves.hpp"
#include "statistics/estimate.hpp"

namespace arenite::fields {

/// A test along one axis that nothing confines, or that draws the sample apart. Stresses and strains count positive in
/// compression and in tension alike.
struct UniaxialTest {
  bool in_tension = false;
  bool failed = false;                   ///< the stress has fallen by a tenth since
  double strength = 0;                   ///< the largest stress, Pa
  double strain = 0;                     ///< there
  std::size_t peak = 0;                  ///< row of the history there
  double modulus = statistics::unknown;  ///< slope of a straight line from a tenth to half of that stress, Pa
};
/// Nothing for other tests, and where there is no stress.
std::optional<UniaxialTest> uniaxial_test(const TestCurves& curves);

/// Compression between sides that stand still.
struct OedometerTest {
  double stress = 0, strain = 0;               ///< along the axis in the end, Pa
  double lateral_ratio = statistics::unknown;  ///< stress across the axis over that along it in the end
  double modulus = statistics::unknown;  ///< slope of stress over strain from half of the largest stress to it, Pa
};
std::optional<OedometerTest> oedometer_test(const Test& test, const TestCurves& curves);

/// Whether all strain is that of the axis, as in a box whose other sides stand still. A box that a pressure closes
/// around grains that do not touch yet makes a sample and tests none.
bool is_oedometric(const Test& test, const TestCurves& curves);

}  // namespace arenite::fields
