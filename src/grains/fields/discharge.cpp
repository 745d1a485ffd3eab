#include "grains/fields/discharge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/problems.hpp"
#include "geometry/face.hpp"
#include "geometry/rectangle.hpp"
#include "grains/fields/loading.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite::fields {
namespace {

constexpr std::size_t intervals =
    400;  // that the time of flow is parted into: enough to find where it is steady, and for blocks within
constexpr double rounding =
    1e-9;  // of all that passes: sums of the same masses in another order differ by less, a grain is more
constexpr double long_pause =
    0.1;  // of the time of flow without a passing: longer than the gaps of a flow that goes on

constexpr double bulk = 0.95;    // of all that passes
constexpr double dribbling = 3;  // times slower than the bulk: stragglers of a silo that has run empty

void check(const std::vector<double>& time, const std::vector<double>& passed) {
  if (time.size() != passed.size())
    throw refusal("there are {} times and {} amounts passed; give one per time", time.size(), passed.size());
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!std::isfinite(time[k]) || !std::isfinite(passed[k]))
      throw refusal("row {} of the passed amounts is not finite", k);
    if (k > 0 && !(time[k] > time[k - 1])) throw refusal("time does not increase in row {} of the passed amounts", k);
  }
}

constexpr const char* opening_in_words[] = {"Narrowest opening between boundaries",
                                            "Narrowest opening in a boundary: four areas over its rim"};

double length_around(const std::vector<Vec3>& rim) {
  double length = norm(rim.front() - rim.back());
  for (std::size_t k = 1; k < rim.size(); ++k) length += norm(rim[k] - rim[k - 1]);
  return length;
}

/// From the points of one boundary to the segments of another.
double shortest_way(const Boundary& from, const Boundary& to) {
  double least = HUGE_VAL;
  const std::size_t n = to.points.size();
  for (const Vec2& place : from.points)
    for (std::size_t k = 0; k + (to.closed ? 0 : 1) < n; ++k)
      least = std::min(least, norm(place - geometry::nearest_on_segment(to.points[k], to.points[(k + 1) % n], place)));
  return least;
}

}  // namespace

Discharge find_discharge(const std::vector<double>& time, const std::vector<double>& passed) {
  check(time, passed);
  Discharge found;
  if (passed.empty()) return found;
  const auto [least, most] = std::minmax_element(passed.begin(), passed.end());
  const double nothing = rounding * std::max(std::abs(*least), std::abs(*most));
  const auto row_where = [&](const auto& holds) {
    return static_cast<std::size_t>(std::find_if(passed.begin(), passed.end(), holds) - passed.begin());
  };
  const auto first = row_where([&](double p) { return p > passed.front() + nothing; });
  auto last = row_where([&](double p) { return p >= passed.back() - nothing; });
  if (first >= last) return found;
  found.stopped = time.back() - time[last] > long_pause * (time[last] - time[first]);
  const auto most_passed =
      row_where([&](double p) { return p >= passed.front() + bulk * (passed.back() - passed.front()); });
  if ((time[last] - time[most_passed]) * bulk > dribbling * (1 - bulk) * (time[most_passed] - time[first]) &&
      most_passed > first)
    last = most_passed;
  const double width = (time[last] - time[first]) / static_cast<double>(std::min(intervals, last - first));
  std::vector<double> rates;
  for (std::size_t k = 0; k < std::min(intervals, last - first); ++k) {
    const double t = time[first] + static_cast<double>(k) * width;
    rates.push_back((at_time(time, passed, t + width) - at_time(time, passed, t)) / width);
  }
  rates.resize(rates.size() - find_steady_state(std::vector<double>(rates.rbegin(), rates.rend())).first);
  const SteadyState steady = find_steady_state(rates);
  found.steady = steady.reached;
  found.begin = time[first] + static_cast<double>(found.steady ? steady.first : 0) * width;
  found.end = found.steady ? time[first] + static_cast<double>(rates.size()) * width : time[last];
  found.rate.value =
      (at_time(time, passed, found.end) - at_time(time, passed, found.begin)) / (found.end - found.begin);
  if (found.steady) found.rate = {found.rate.value, steady.mean.error, steady.mean.freedom};
  return found;
}

std::vector<double> discharge_rate(const std::vector<double>& time, const std::vector<double>& grains,
                                   const std::vector<double>& amount) {
  constexpr double grains_of_a_mean = 20;
  std::vector<double> rate(time.size(), 0.0);
  std::size_t from = 0;
  for (std::size_t k = 1; k < time.size(); ++k) {
    const auto passed_since = [&](std::size_t row) { return grains[k] - grains[row]; };
    while (from + 1 < k && (grains[from + 1] <= grains.front() || passed_since(from + 1) >= grains_of_a_mean)) ++from;
    if (grains[k] > grains.front()) rate[k] = (amount[k] - amount[from]) / (time[k] - time[from]);
  }
  return rate;
}

Passed passed_in(const History& rows) {
  const auto either = [&](const char* below, const char* left) {
    const std::vector<double>* values = rows.find(below);
    return values ? values : rows.find(left);
  };
  return {either("passed", "removed"), either("passed_mass", "removed_mass")};
}

void put_discharge_rates(const History& rows, const std::vector<double>& time, statistics::Columns& to) {
  const auto [grains, mass] = passed_in(rows);
  if (!grains || !mass) return;
  to.put("discharge_rate", "1/s", "Grains that pass per time, over the last twenty of them",
         discharge_rate(time, *grains, *grains));
  to.put("discharge_mass_rate", "kg/s", "Mass that passes per time, over the last twenty grains",
         discharge_rate(time, *grains, *mass));
}

Numbers discharge_numbers(const History& history) {
  using statistics::described;
  const auto* time = history.find("time");
  const auto [grains, mass] = passed_in(history);
  if (!time || !mass || !grains || time->size() < 2) return Numbers::tree();
  const Discharge by_mass = find_discharge(*time, *mass), by_grains = find_discharge(*time, *grains);
  if (!std::isfinite(by_mass.rate.value)) return Numbers::tree();
  const auto estimate = [](const statistics::Measured& rate, const char* unit, const char* sentence) {
    return described({{"value", rate.value}, {"error", rate.error}}, unit, sentence);
  };
  return {{"steady", described(by_mass.steady, "", "Whether the discharge has a steady part")},
          {"rate_kg_s", estimate(by_mass.rate, "kg/s",
                                 by_mass.steady ? "Rate of discharge over its steady part"
                                                : "Mean rate of a discharge that has no steady part")},
          {"rate_grains_s", estimate(by_grains.rate, "1/s", "The same as a number of grains")},
          {"begin_s", described(by_mass.begin, "s", "Start of the time that the rate is of")},
          {"end_s", described(by_mass.end, "s", "End of it")},
          {"stopped", described(by_mass.stopped, "",
                                "Whether nothing passes any more in the end: the container is empty or clogged")}};
}

double narrowest_opening(const Domain& domain) {
  std::optional<double> least;
  for (const Boundary& a : domain.boundaries)
    for (const Boundary& b : domain.boundaries)
      if (&a != &b && a.present && b.present) least = std::min(least.value_or(HUGE_VAL), shortest_way(a, b));
  return least.value_or(statistics::unknown);
}

double narrowest_opening(const DomainIn<3>& domain) {
  std::optional<double> least;
  for (const BoundaryIn<3>& boundary : domain.boundaries) {
    if (!boundary.present) continue;
    auto rims = geometry::ends_of(geometry::faces_of(boundary.points, boundary.corners));
    const auto area = [](const auto& rim) { return norm(geometry::area_vector(rim)); };
    std::erase_if(rims, [](const auto& rim) { return rim.size() < 3; });
    if (rims.size() < 2) continue;
    rims.erase(std::ranges::max_element(rims, {}, area));  // where it ends itself
    for (const auto& rim : rims) least = std::min(least.value_or(HUGE_VAL), 2 * area(rim) / length_around(rim));
  }
  return least.value_or(statistics::unknown);
}

std::optional<double> too_low_filling(const Numbers& stage) {
  constexpr double lowest = 2;  // openings
  const auto number_at = [&](const char* path) {
    const Numbers* node = stage.at_path(path);
    return node && node->is_number() ? node->get<double>() : statistics::unknown;
  };
  const double filling = number_at("/surface/height_before_m") / number_at("/discharge/opening_m");
  return filling < lowest ? std::optional(filling) : std::nullopt;
}

template <int D> Numbers discharge_of(const StageResultIn<D>& result) {
  Numbers j = discharge_numbers(result.history);
  if (j.empty()) return j;
  const double opening = narrowest_opening(result.snapshots.back().packing.domain);
  if (std::isfinite(opening)) j["opening_m"] = statistics::described(opening, "m", opening_in_words[D - 2]);
  return j;
}
template Numbers discharge_of(const StageResultIn<2>&);
template Numbers discharge_of(const StageResultIn<3>&);

}  // namespace arenite::fields
