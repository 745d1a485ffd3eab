#pragma once
#include <string>

#include "ledger/claims/paper_runs.hpp"

/// Checks over all pairs of size ratio and volume ratio.
namespace arenite::ledger {

/// The least and the greatest of all pairs, held against bounds.
void add_range(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, double low, double high);
/// The mean over pairs goes this way (+1, -1) beyond 2 s.e., and no pair goes the other way beyond 2 s.e.
Check in_all_pairs(const std::string& what, const std::string& source, const PairMeans& differences, int direction);
/// Every pair goes this way beyond 2 s.e.; the one that is least sure is shown.
Check in_every_pair(const std::string& what, const std::string& source, const PairMeans& differences, int direction);
/// The rise from the least to the greatest gamma goes this way beyond 2 s.e. for every theta.
void add_rises(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, int direction);

/// R^2 of a line through the means of one theta, against gamma or its inverse; unknown for fewer than three gammas.
enum class Against { gamma, inverse_gamma };
Value straightness(const PairMeans& means, double theta, Against against);
/// At least 0.98, and rising.
Check straight(const std::string& what, const std::string& source, const PairMeans& means, double theta, Against against);

}  // namespace arenite::ledger
