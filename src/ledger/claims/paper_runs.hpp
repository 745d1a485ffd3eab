#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ledger/claim.hpp"
#include "ledger/results.hpp"
#include "ledger/sensitivity.hpp"
#include "ledger/trends.hpp"

/// Runs of the study "paper", put together by size ratio gamma, volume ratio theta and what cements them.
namespace arenite::ledger {

/// Half base of the bridges over the radius of their grain; `full`: all space between the grains is matrix.
inline constexpr double full = 0;
/// The partly filled ones.
inline const std::vector<double> widths{0.2, 0.4, 0.6, 0.8, 1};

/// "large", "variance": the flat name of a statistic of the vertical node stress in a set of nodes.
std::string stress_of(const std::string& set, const std::string& statistic);

double gamma_of(const Run& run);
double theta_of(const Run& run);
/// `full` or the width.
double cement_of(const Run& run);

/// A mean over the samples of one pair, cemented alike.
struct PairMean {
  double gamma = 0, theta = 0, width = full;
  Value value;
};
using PairMeans = std::vector<PairMean>;

/// Means over the samples of all pairs with this cement, by gamma and then theta.
PairMeans pair_means(const Results& results, const Number& number, double width);
/// Those that are wanted.
PairMeans only(const PairMeans& means, const std::function<bool(const PairMean&)>& wanted);
/// a - b of the same pair; pairs that either does not have are left out.
PairMeans difference(const PairMeans& a, const PairMeans& b);

/// Against gamma, of one theta.
Series against_gamma(const PairMeans& means, double theta);
std::vector<double> thetas(const PairMeans& means);
std::vector<double> gammas(const PairMeans& means);
/// The value of one pair; unknown if there is none.
Value of_pair(const PairMeans& means, double gamma, double theta);
/// Mean over all pairs, its error from those of the pairs.
Value overall(const PairMeans& means);

/// The least and the greatest of all pairs, held against bounds.
void add_range(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, double low, double high);
/// The mean over pairs goes this way (+1, -1) beyond 2 s.e., and no pair goes the other way beyond 2 s.e.
Check in_all_pairs(const std::string& what, const std::string& source, const PairMeans& differences, int direction);
/// The rise from the least to the greatest gamma goes this way beyond 2 s.e. for every theta.
void add_rises(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, int direction);

/// Full samples, or such with bridges of eta 0.4.
enum class Filling { complete, part };
/// What a number becomes with each choice that the paper leaves open (study "paper-choices"), at the ends of gamma and between
/// them, for the least and the greatest theta.
void add_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const WantedAtEnds& wanted = {}, Filling filling = Filling::complete);

}  // namespace arenite::ledger
