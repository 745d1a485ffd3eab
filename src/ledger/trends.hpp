#pragma once
#include "ledger/claim.hpp"
#include "ledger/results.hpp"

namespace arenite::ledger {

/// Beyond how many standard errors a difference counts.
inline constexpr double beyond = 2;

/// A number with its standard error, NaN where not known.
struct Value {
  double value = statistics::unknown, error = statistics::unknown;
  Value() = default;
  Value(double v, double e = statistics::unknown) : value(v), error(e) {}
  Value(const statistics::Measured& m) : value(m.value), error(m.error) {}
};

// Errors of independent values add in squares; one that is not known makes the result's unknown.
Value difference(const Value& a, const Value& b);
Value ratio(const Value& a, const Value& b);

/// Last mean minus first.
Value rise(const Series& points);
/// Slope of a least-squares line through the means, its error from those of the means where all are known, otherwise from
/// their scatter about the line. Needs three points, or two with errors.
Value slope(const Series& points);
/// R^2 of that line.
double line_r2(const Series& points);
/// Rank correlation of x and mean.
double spearman(const Series& points);

// Checks of one number; unknown where the number, or an error that is needed, is.
Check within(std::string what, const Value& ours, double source, double tolerance, std::string unit = "");
Check between(std::string what, std::string source, const Value& ours, double low, double high, std::string unit = "");
Check above(std::string what, std::string source, const Value& ours, double bound, std::string unit = "");
Check below(std::string what, std::string source, const Value& ours, double bound, std::string unit = "");
/// Greater than zero, smaller than zero, no further from zero than `beyond` standard errors.
Check positive(std::string what, std::string source, const Value& ours, std::string unit = "");
Check negative(std::string what, std::string source, const Value& ours, std::string unit = "");
Check none(std::string what, std::string source, const Value& ours, std::string unit = "");

/// "0.403 +- 0.012".
std::string text_of(const Value& value);
/// "law R: slope of z 0.403 +- 0.012 (holds); ...", of what is known; empty if nothing is.
std::string told(const std::string& who, const Verdict& verdict);

}  // namespace arenite::ledger
