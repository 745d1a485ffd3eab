#pragma once
#include <functional>
#include <string>
#include <vector>

#include "validation/claim.hpp"
#include "validation/results.hpp"
#include "validation/trends.hpp"

/// Runs of cemented samples, put together by size ratio gamma, volume ratio theta and what cements them.
namespace arenite::validation {

/// Half base of the bridges over the radius of their grain; `full`: all space between the grains is matrix.
inline constexpr double full = 0;

/// The runs that a claim of the paper is judged by.
struct Samples {
  std::vector<Run> runs;
  std::vector<double> widths;          ///< of the bridges, rising
  std::string component = "sigma_yy";  ///< of the node stress: along the load
};
/// The study "paper": pulled, bridges of five widths.
Samples paper_samples(const Results& results);

double gamma_of(const Run& run);
double theta_of(const Run& run);
/// `full` or the width.
double cement_of(const Run& run);

/// A number of one sample; `name` tells the packing, whatever cements it.
struct Sample {
  std::string name;
  double number = 0;
};

/// A mean over the samples of one pair, cemented alike.
struct PairMean {
  double gamma = 0, theta = 0, width = full;
  Value value;
  std::vector<Sample> samples;
};
using PairMeans = std::vector<PairMean>;

/// Means over the samples of all pairs with this cement, by gamma and then theta; their errors with_pooled_variance().
PairMeans pair_means(const Samples& samples, const Number& number, double width = full);
/// The same of a statistic ("variance") of the node stress in a set of nodes ("large").
PairMeans stress_means(const Samples& samples, const std::string& set, const std::string& statistic,
                       double width = full);
/// One pair from its samples.
PairMean pair_of_samples(double gamma, double theta, double width, std::vector<Sample> samples);
/// Every pair without its k-th sample; one pair without a sample.
PairMeans without(PairMeans means, std::size_t k);
PairMeans without(PairMeans means, double gamma, double theta, const std::string& sample);
/// Samples of the pair that has fewest.
std::size_t fewest_samples(const std::vector<PairMeans>& means);
/// Those that are wanted.
PairMeans only(const PairMeans& means, const std::function<bool(const PairMean&)>& wanted);
/// Those whose small and large grains differ enough to be classes of their own.
PairMeans classed(const PairMeans& means);
PairMeans of_theta(const PairMeans& means, double theta);
/// a - b of the same pair, sample by sample: differently cemented they are the same packing. What either lacks is left
/// out.
PairMeans difference(const PairMeans& a, const PairMeans& b);

/// Mean over several cements of the same pair, sample by sample for the same reason.
PairMeans mean_of(const std::vector<PairMeans>& all);

/// Against gamma, of one theta.
Series against_gamma(const PairMeans& means, double theta);
/// y against x over the pairs that both have, in rising order of x.
Series against(const PairMeans& x, const PairMeans& y);
std::vector<double> thetas(const PairMeans& means);
std::vector<double> gammas(const PairMeans& means);
/// The value of one pair; unknown if there is none.
Value of_pair(const PairMeans& means, double gamma, double theta);
/// One member a pair; further seeds are of the pair, with all its cements.
Family members(const PairMeans& means);
/// Mean over all pairs, its error from those of the pairs.
Value overall(const PairMeans& means);

/// "gamma 2.5, theta 1.4".
std::string name_of(const PairMean& m);

}  // namespace arenite::validation
