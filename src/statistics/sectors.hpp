#pragma once
#include <vector>

/// Directions that are counted in sectors, or in cells of a sphere, of one size.
namespace arenite::statistics {

/// Counts over those of as many directions without a preferred one, `whole` of them in all.
std::vector<double> over_isotropic(std::vector<double> counts, double whole);

/// The distribution of second order over the isotropic one, 1 + a cos 2(theta - direction) (T eq. 1.8), at so many
/// angles from 0 to half a turn; degrees.
std::vector<double> second_order_distribution(double anisotropy, double direction, int angles);

}  // namespace arenite::statistics
