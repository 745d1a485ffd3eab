#pragma once

/// Exponential and Gaussian laws cut at both ends.
namespace arenite::statistics {

/// Rate s of the exponential exp(-s y) on 0 <= y <= length that has this mean: the maximum-likelihood fit. Negative
/// where it rises.
double cut_exponential_rate(double mean, double length);

/// theta >= 0 of exp(-theta u^2) on a <= u <= b that is likeliest for values of this mean square; 0 where none that
/// falls is.
double cut_gaussian_rate(double mean_square, double a, double b);

/// ln of the integral of exp(-s y) over 0..length.
double log_integral_exponential(double s, double length);

/// ln of the integral of exp(-theta u^2) over a..b.
double log_integral_gaussian(double theta, double a, double b);

}  // namespace arenite::statistics
