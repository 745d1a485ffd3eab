#include "ledger/claims/paper_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace arenite::ledger {
namespace {

bool less(const PairMean& a, const PairMean& b) { return a.value.value < b.value.value; }

/// Standard errors that a pair lies to this side of zero.
double sureness(const PairMean& m, int direction) { return direction * m.value.value / m.value.error; }

bool is_beyond(const PairMean& m, int direction) { return direction * m.value.value > beyond * m.value.error; }

Series line_points(const PairMeans& means, double theta, Against against) {
  Series points = against_gamma(means, theta);
  if (against == Against::gamma) return points;
  for (Point& p : points) p.x = 1 / p.x;
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

void add_range(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, double low, double high) {
  const auto [least, greatest] = std::minmax_element(means.begin(), means.end(), less);
  const bool any = !means.empty();
  verdict.checks.push_back(between("least " + what + (any ? " (" + name_of(*least) + ")" : ""), source, any ? least->value : Value(), low, high));
  verdict.checks.push_back(between("greatest " + what + (any ? " (" + name_of(*greatest) + ")" : ""), source, any ? greatest->value : Value(), low, high));
}

Check in_all_pairs(const std::string& what, const std::string& source, const PairMeans& differences, int direction) {
  const Value mean = overall(differences);
  const PairMean* against = nullptr;
  std::size_t sure = 0;
  for (const PairMean& m : differences) {
    sure += is_beyond(m, direction);
    if (is_beyond(m, -direction) && (!against || direction * m.value.value < direction * against->value.value)) against = &m;
  }
  const std::string counted = fmt::format("{}, mean of {} pairs, {} of them beyond 2 s.e.", what, differences.size(), sure);
  Check check = direction > 0 ? positive(counted, source, mean) : negative(counted, source, mean);
  check.tolerance += ", no pair against it by 2 s.e.";
  if (against) {
    check.holds = Holds::no;
    check.what += fmt::format("; against it {}: {}", name_of(*against), text_of(against->value));
  }
  return check;
}

Check in_every_pair(const std::string& what, const std::string& source, const PairMeans& differences, int direction) {
  const auto least = std::min_element(differences.begin(), differences.end(), [&](const PairMean& a, const PairMean& b) { return sureness(a, direction) < sureness(b, direction); });
  const bool any = least != differences.end();
  const auto sure = std::count_if(differences.begin(), differences.end(), [&](const PairMean& m) { return is_beyond(m, direction); });
  const std::string counted = any ? fmt::format("{}, {} of {} pairs beyond 2 s.e., least sure {}", what, sure, differences.size(), name_of(*least)) : what;
  Check check = direction > 0 ? positive(counted, source, any ? least->value : Value()) : negative(counted, source, any ? least->value : Value());
  check.tolerance += " in every pair";
  return check;
}

void add_rises(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, int direction) {
  for (const double theta : thetas(means)) {
    const std::string name = fmt::format("{}, change from the least to the greatest gamma, theta {:g}", what, theta);
    const Value change = rise(against_gamma(means, theta));
    verdict.checks.push_back(direction > 0 ? positive(name, source, change) : negative(name, source, change));
  }
  if (means.empty()) verdict.checks.push_back(positive(what + " against gamma", source, {}));
}

Value straightness(const PairMeans& means, double theta, Against against) {
  if (against_gamma(means, theta).size() < 3) return {};
  return jackknifed(of_theta(means, theta), [&](const PairMeans& some) { return line_r2(line_points(some, theta, against)); });
}

Check straight(const std::string& what, const std::string& source, const PairMeans& means, double theta, Against against) {
  const Value r2 = straightness(means, theta, against);
  Check check = above(fmt::format("R^2 of {} against {}, theta {:g}", what, against == Against::gamma ? "gamma" : "1/gamma", theta), source, r2, 0.98);
  check.tolerance = ">= 0.98, rising";
  if (check.holds == Holds::yes && rise(line_points(means, theta, against)).value <= 0) check.holds = Holds::no;
  return check;
}

}  // namespace arenite::ledger
