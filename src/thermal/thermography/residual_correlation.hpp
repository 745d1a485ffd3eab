#pragma once
#include <Eigen/Dense>
#include <vector>

namespace arenite::thermography {

/// How what a fit leaves goes together, from frame to frame and from pixel to pixel.
struct ResidualCorrelation {
  std::vector<double> lag;          ///< of a pixel with itself so many frames later, from 1 on, until it is lost in noise
  double pixels = 1;                ///< as many independent pixels vary as much together

  /// Variance of the weighed sum of a pixel's frames over that in white noise.
  double widening(const Eigen::VectorXd& weight) const;
};

/// Mean square of so many normal numbers that lies `deviations` above what is expected, as a normal number's would (Wilson and Hilferty 1931).
double chi_squared_above(double numbers, double deviations);

/// Of pixels x frames, left by a fit of the functions `fitted` (functions x frames, orthonormal), which takes some correlation with it.
ResidualCorrelation residual_correlation(const Eigen::MatrixXd& residual, const Eigen::MatrixXd& fitted);

}  // namespace arenite::thermography
