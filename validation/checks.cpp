#include "validation/checks.hpp"

#include <fmt/core.h>

#include <cmath>

namespace arenite::validation {
namespace {

std::string limits_of(const Range& range) {
  if (std::isinf(range.low)) return fmt::format("< {:.4g}", range.high);
  if (std::isinf(range.high)) return fmt::format("> {:.4g}", range.low);
  return fmt::format("{:.4g} to {:.4g}", range.low, range.high);
}

Check check(std::string what, std::string source, const Value& ours, std::string unit, const Range& range) {
  return {std::move(what), std::move(source), std::move(unit), limits_of(range), ours, range, outcome_of(ours, range)};
}

}  // namespace

std::string capital(std::string text) {
  const bool is_symbol = text.size() > 1 && text[1] == '_';
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z' && !is_symbol) text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

Outcome outcome_of(const Value& ours, const Range& range) {
  if (!std::isfinite(ours.value)) return Outcome::unknown;
  const double half = half_interval(ours), low = ours.value - half, high = ours.value + half;
  if (low > range.low && high < range.high) return Outcome::holds;
  // An error of zero leaves nothing open: what lies on the bound is not inside.
  if (high < range.low || low > range.high || half == 0) return Outcome::fails;
  return Outcome::undecided;
}

Check between(std::string what, std::string source, const Value& ours, double low, double high, std::string unit) {
  return check(std::move(what), std::move(source), ours, std::move(unit), {low, high});
}

Check within(std::string what, const Value& ours, double source, double tolerance, std::string unit) {
  Check within = between(std::move(what), fmt::format("{:.4g}", source), ours, source - tolerance, source + tolerance,
                         std::move(unit));
  within.wanted = fmt::format("{:.4g} +- {:.3g}", source, tolerance);
  return within;
}

Check above(std::string what, std::string source, const Value& ours, double bound, std::string unit) {
  return check(std::move(what), std::move(source), ours, std::move(unit), {.low = bound});
}

Check below(std::string what, std::string source, const Value& ours, double bound, std::string unit) {
  return check(std::move(what), std::move(source), ours, std::move(unit), {.high = bound});
}

Check positive(std::string what, std::string source, const Value& ours, std::string unit) {
  return above(std::move(what), std::move(source), ours, 0, std::move(unit));
}

Check negative(std::string what, std::string source, const Value& ours, std::string unit) {
  return below(std::move(what), std::move(source), ours, 0, std::move(unit));
}

Check equivalent(std::string what, std::string source, const Value& ours, double margin, std::string unit) {
  Check same = check(std::move(what), std::move(source), ours, std::move(unit), {-margin, margin});
  same.wanted = fmt::format("0 +- {:.3g}", margin);
  return same;
}

Check differs(std::string what, std::string source, const Value& ours, double margin, std::string unit) {
  Check other = check(std::move(what), std::move(source), ours, std::move(unit), {});
  other.wanted = fmt::format("not 0, and not surely within {:.2g} of it", margin);
  other.range = ours.value < 0 ? Range{.high = 0} : Range{.low = 0};
  if (outcome_of(ours, {-margin, margin}) == Outcome::holds) other.outcome = Outcome::fails;
  else other.outcome = outcome_of(ours, other.range);
  return other;
}

Check as(Kind kind, Check check) {
  check.kind = kind;
  return check;
}

Check drawn(std::vector<Draw> draws, Check check) {
  check.draws = std::move(draws);
  return check;
}

Check decided_by(Decider decider, Check check) {
  check.decider = decider;
  return check;
}

Check reported(std::string what, const Value& ours, std::string unit) {
  return {std::move(what), "", std::move(unit), "", ours, {}, Outcome::unknown, Kind::beside};
}

void add_beside(Judgement& judgement, const std::string& conditions, const std::vector<Check>& checks) {
  std::size_t known = 0, hold = 0;
  std::string fail;
  for (Check check : checks) {
    if (check.outcome == Outcome::unknown) continue;
    ++known;
    hold += check.outcome == Outcome::holds;
    if (check.outcome == Outcome::fails)
      fail += fmt::format("{} {} ({})", fail.empty() ? "; failing:" : ",", check.what, text_of(check.ours));
    check.what += ", " + conditions;
    judgement.checks.push_back(beside(std::move(check)));
  }
  if (known > 0)
    judgement.findings.push_back(
        capital(fmt::format("{}, {} of {} corresponding checks hold{}.", conditions, hold, known, fail)));
}

}  // namespace arenite::validation
