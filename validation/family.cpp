#include "validation/family.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace arenite::validation {
namespace {

/// Value over error; sides of zero without one.
double sureness(const Value& v, double distance) {
  return v.error > 0 ? distance / v.error : std::copysign(HUGE_VAL, distance);
}

/// How far inside the range a member lies, in its errors.
double margin(const Value& v, const Range& range) {
  const double inside = std::min(v.value - range.low, range.high - v.value);
  return v.error >= 0 ? sureness(v, inside) : inside;
}

/// How often a true value at the nearer end of the range would give one as far outside; 1 inside.
double chance_inside(const Value& v, const Range& range) {
  if (v.value <= range.low) return 1 - chance_above(v, range.low);
  return v.value >= range.high ? chance_above(v, range.high) : 1;
}

std::vector<bool> outside(const Family& family, const Range& range) {
  std::vector<double> chances;
  for (const Member& m : family) chances.push_back(chance_inside(m.value, range));
  return holm(chances, usual_side);
}

Range this_way(int direction) { return direction > 0 ? Range{.low = 0} : Range{.high = 0}; }

std::size_t count_inside(const Family& family, const Range& range) {
  return static_cast<std::size_t>(std::count_if(
      family.begin(), family.end(), [&](const Member& m) { return outcome_of(m.value, range) == Outcome::holds; }));
}

Family::const_iterator least_sure(const Family& family, const Range& range) {
  return std::min_element(family.begin(), family.end(), [&](const Member& a, const Member& b) {
    return margin(a.value, range) < margin(b.value, range);
  });
}

/// Those that go the other way beyond chance: "gamma 5, theta 6 (-0.31 +- 0.04)".
std::string contradictions(const Family& family, int direction) {
  std::string text;
  const auto wrong = outside(family, this_way(direction));
  for (std::size_t k = 0; k < family.size(); ++k)
    if (wrong[k]) text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", family[k].name, text_of(family[k].value));
  return text;
}

}  // namespace

std::vector<bool> holm(const std::vector<double>& chances, double level) {
  std::vector<std::size_t> order(chances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto known = [&](std::size_t k) { return std::isnan(chances[k]) ? 1.0 : chances[k]; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return known(a) < known(b); });
  std::vector<bool> rejected(chances.size(), false);
  for (std::size_t k = 0; k < order.size() && known(order[k]) < level / static_cast<double>(order.size() - k); ++k)
    rejected[order[k]] = true;
  return rejected;
}

namespace {

/// Further seeds of the members that do not hold.
std::vector<Draw> draws_of(const Family& family, const Range& range) {
  std::vector<Draw> draws;
  for (const Member& m : family) {
    if (outcome_of(m.value, range) == Outcome::holds) continue;
    for (const Draw& draw : m.draws)
      if (std::ranges::count(draws, draw) == 0) draws.push_back(draw);
  }
  return draws;
}

}  // namespace

Check every(const std::string& what, const std::string& source, const Family& family, const Range& range,
            const std::string& unit) {
  Check check = between(what, source, {}, range.low, range.high, unit);
  if (std::isinf(range.low)) check = below(what, source, {}, range.high, unit);
  if (std::isinf(range.high)) check = above(what, source, {}, range.low, unit);
  if (family.empty()) return check;
  const Member& worst = *least_sure(family, range);
  check.ours = worst.value;
  // One that lies outside may fail them all, alone.
  check.draws = margin(worst.value, range) < 0 ? worst.draws : draws_of(family, range);
  check.outside = usual_side / static_cast<double>(family.size());
  check.outcome = Outcome::holds;
  for (const Member& m : family)
    if (const Outcome one = outcome_of(m.value, range); one != Outcome::holds && check.outcome != Outcome::unknown)
      check.outcome = one == Outcome::unknown ? one : Outcome::undecided;
  const auto wrong = outside(family, range);
  const auto failing = std::count(wrong.begin(), wrong.end(), true);
  if (failing > 0) check.outcome = Outcome::fails;
  if (family.size() > 1)
    check.what += fmt::format(", in {} of {}{}; worst case {}", count_inside(family, range), family.size(),
                              failing > 0 ? fmt::format(", violated in {}", failing) : "", worst.name);
  else check.what += ", " + worst.name;
  return check;
}

Check on_the_whole(const std::string& what, const std::string& source, const Value& size, const Family& differences,
                   int direction) {
  Check check = trend(what, source, size, differences, direction);
  if (differences.size() > 1)
    check.what +=
        fmt::format(", mean of {}, {} of them beyond their error; worst case {}", differences.size(),
                    count_inside(differences, this_way(direction)), least_sure(differences, this_way(direction))->name);
  return check;
}

Check on_the_whole(const std::string& what, const std::string& source, const Family& differences, int direction) {
  std::vector<std::pair<double, Value>> terms;
  for (const Member& m : differences) terms.emplace_back(1.0 / static_cast<double>(differences.size()), m.value);
  return on_the_whole(what, source, terms.empty() ? Value() : weighted_sum(terms), differences, direction);
}

Check trend(const std::string& what, const std::string& source, const Value& size, const Family& against,
            int direction) {
  Check check = direction > 0 ? positive(what, source, size) : negative(what, source, size);
  check.draws = draws_of(against, this_way(direction));
  if (check.outcome == Outcome::unknown) return check;
  if (const std::string wrong = contradictions(against, direction); !wrong.empty()) {
    check.outcome = Outcome::fails;
    check.what += "; contradicting: " + wrong;
  }
  return check;
}

}  // namespace arenite::validation
