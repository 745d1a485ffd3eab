#pragma once
#include <Eigen/Dense>
#include <vector>

namespace arenite::thermography {

/// The time in the middle between the two frames between which the pixels of `series` (pixels x frames, over their noise)
/// jump most: each split of the film is judged by what polynomials of this order on both sides explain. InputError for too
/// few frames.
double find_step(const Eigen::MatrixXd& series, const std::vector<double>& time, int drift_order);

}  // namespace arenite::thermography
