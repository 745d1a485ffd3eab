#pragma once
#include <variant>
#include <vector>

#include "grains/fields/loading.hpp"

namespace arenite::fields {

/// One of several results that are shown together: a test of disks, or a stage of spheres.
using AnyTest = std::variant<Test, const SphereResult*>;

/// Curves over several results, one value each, in the order of the first column.

/// mu(I) and phi(I) of tests: `inertial_number`, `mu`, `solid_fraction` of their critical state (test_numbers.hpp) or,
/// where none is reached, means over the steady part of each with their errors. mu is that of the sheared sides, or q/p
/// where nothing is sheared along them, and a ratio of means. Throws InputError for a stage without stresses on its
/// sides.
statistics::Columns rheology(const std::vector<AnyTest>& tests);

/// Critical states against `friction`, mu between grains as the stages asked for it: `mu`, `solid_fraction` with their
/// errors; `reached` is 0 where there is none: the means are then those of the second half.
statistics::Columns critical_states(const std::vector<AnyTest>& tests);

/// Of stages that discharge: `opening`, m, the narrowest between boundaries, and `rate`, kg/s. Others are left out.
statistics::Columns discharges(const std::vector<AnyTest>& tests);

/// Of collapses: `aspect_ratio`, height over width, before; `runout`, way of the front over that width; `height` of the
/// deposit over that width; `angle` of the deposit, deg. Others are left out.
statistics::Columns runouts(const std::vector<AnyTest>& tests);

/// Of silos (silo.hpp): `height` of the filling, m, `pressure` on the floor, `hydrostatic` pressure of a liquid of the
/// same bulk density, Pa, `wall_friction` as mobilised, `ratio` of horizontal and vertical stress, `width`, m. Throws
/// InputError for a stage that is none.
statistics::Columns silos(const std::vector<AnyTest>& tests);

/// Ratio of the means of two stresses, over the part in which their ratio is steady; unknown where nothing is loaded.
statistics::Estimate steady_ratio(const std::vector<double>& shear, const std::vector<double>& normal);

}  // namespace arenite::fields
