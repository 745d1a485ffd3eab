#include "grains/fields/stage_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "grains/fields/steady_state.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {
namespace {

constexpr std::size_t fewest_states = 4,
                      most_states =
                          12;     // by which the scatter of a number in time is known, and that are measured for it
constexpr double restless = 0.1;  // scatter of the pressure in time beyond which one moment tells little of the others
constexpr double beyond_blocks =
    1.5;  // scatter in time over an error by blocks that tells more than that both are rough

/// A sum of two columns with these weights; zeros where there is none.
std::vector<double> weighed(const History& history, double x, const std::string& one, double y,
                            const std::string& other, std::size_t rows) {
  std::vector<double> result(rows, 0.0);
  const auto *a = history.find(one), *b = history.find(other);
  for (std::size_t k = 0; k < rows; ++k) result[k] = x * (a ? (*a)[k] : 0) + y * (b ? (*b)[k] : 0);
  return result;
}

std::vector<double> quotient(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] /= b[k];
  return a;
}

statistics::Measured mean_of_later(const std::vector<double>& values) {
  const auto late = later_half(values);
  return statistics::mean_of({late.begin(), late.end()});
}

double deviation(const std::vector<double>& values) {
  const auto mean = mean_of_later(values);
  return mean.error * std::sqrt(mean.freedom + 1);
}

/// Differences of values from the next, the second and the third after them, the shorter way around where they are
/// angles of a `period`: those from the next alone miss what lasts from state to state.
std::vector<double> differences(const std::vector<double>& values, double period) {
  std::vector<double> found;
  for (std::size_t lag = 1; lag <= 3; ++lag)
    for (std::size_t k = lag; k < values.size(); ++k) {
      const double apart = values[k] - values[k - lag];
      found.push_back(period > 0 ? std::remainder(apart, period) : apart);
    }
  return found;
}

/// Standard deviation of values that may drift (J. von Neumann, Ann. Math. Stat. 12, 367, 1941).
double deviation_in_time(const std::vector<double>& values) {
  double squares = 0;
  const auto apart = differences(values, 0);
  for (const double d : apart) squares += d * d;
  return std::sqrt(squares / (2 * static_cast<double>(apart.size())));
}

/// The same of angles: the circular one (K. V. Mardia, Statistics of Directional Data, 1972), which a few states
/// without a direction do not rule, and at most that of no direction at all.
double deviation_in_time(const std::vector<double>& values, double period) {
  const double turn = 2 * std::numbers::pi / period, none = period / std::sqrt(12.0);
  double resultant = 0;
  const auto apart = differences(values, period);
  for (const double d : apart) resultant += std::cos(turn * d) / static_cast<double>(apart.size());
  return resultant > 0 ? std::min(none, std::sqrt(-std::log(resultant)) / turn) : none;
}

/// At most so many states, evenly from the later two thirds of a stage, the last left out, which is measured already.
std::vector<const Packing*> states_before_the_last(const StageResult& result) {
  const std::size_t all = result.snapshots.size(), first = all / 3, many = std::min(all - first, most_states);
  std::vector<const Packing*> states;
  for (std::size_t k = 0; k + 1 < many; ++k)
    states.push_back(&result.snapshots[first + k * (all - 1 - first) / (many - 1)].packing);
  return states;
}

using Nodes = std::vector<const Numbers*>;

Nodes below(const Nodes& nodes, std::string_view name) {
  Nodes found;
  for (const Numbers* node : nodes)
    if (const auto at = node->is_tree() ? node->find(name) : node->end(); at != node->end()) found.push_back(&*at);
  return found;
}

/// An error, or the scatter of the value over states where that is clearly larger; lists item by item.
Numbers widened(const Numbers& value, const Numbers& error, const Nodes& of_states, double period) {
  if (value.is_list()) {
    Numbers out = Numbers::list();
    for (std::size_t i = 0; i < value.size(); ++i) {
      Nodes items;
      for (const Numbers* node : of_states)
        if (node->is_list() && i < node->size()) items.push_back(&(*node)[i]);
      out.push_back(widened(value[i], error.is_list() && i < error.size() ? error[i] : Numbers(), items, period));
    }
    return out;
  }
  std::vector<double> values;
  for (const Numbers* node : of_states)
    if (node->is_number()) values.push_back(node->get<double>());
  if (!value.is_number() || values.size() < fewest_states) return error;
  const double scatter = period > 0 ? deviation_in_time(values, period) : deviation_in_time(values);
  return error.is_number() && scatter <= beyond_blocks * error.get<double>() ? error : Numbers(scatter);
}

/// Another error of a number, and of the number beside it that repeats it ("beta_error" beside "beta").
void set_error(Numbers& group, const std::string& name, Numbers& item, Numbers error) {
  if (const std::string own = name + "_error"; group.contains(own)) {
    Numbers& beside = group[own];
    Numbers repeated = error;
    repeated.means_as(beside);
    beside = std::move(repeated);
  }
  item["error"] = std::move(error);
}

double period_of(const Numbers& number) { return number.meaning() ? number.meaning()->period : 0; }

/// Of all numbers that may have an error.
void widen(Numbers& node, const Nodes& states) {
  for (auto&& [name, item] : node.items())
    if (item.is_tree() && item.contains("error")) {
      set_error(node, name, item,
                widened(item["value"], item["error"], below(below(states, name), "value"), period_of(item)));
    } else if (item.is_tree()) {
      widen(item, below(states, name));
    }
}

void forget_errors(Numbers& node) {
  for (auto&& [name, item] : node.items())
    if (item.is_tree() && item.contains("error")) set_error(node, name, item, {});
    else if (item.is_tree()) forget_errors(item);
}

/// Errors of a moment as what they are worth for others.
Numbers texture_numbers(const StageEnd& end) {
  Numbers own = texture::numbers(end.texture);
  if (!end.options || !end.options->in_time || !std::isfinite(end.options->in_time->pressure)) return own;
  texture::Options options = *end.options;
  options.rev.sizes = 0;
  std::vector<Numbers> measured;
  for (const Packing* state : states_before_the_last(end.result))
    measured.push_back(texture::numbers(texture::measure(*state, options)));
  if (measured.size() + 1 >= fewest_states) {
    Nodes states;
    for (const Numbers& one : measured) states.push_back(&one);
    const Numbers last = own;
    states.push_back(&last);
    widen(own, states);
  } else if (end.options->in_time->pressure > restless) {
    forget_errors(own);
    own["notes"].push_back(
        "The sample fluctuates as a whole, so that errors are unknown from its last state; store more states "
        "(snapshots = 8 or more).");
  }
  return own;
}

/// Every statistic that there is, in the order of their numbers.
constexpr StageStatistic* statistics[] = {texture_numbers, load_numbers, energy_numbers, flow_numbers,
                                          cohesion_numbers};

}  // namespace

std::vector<double> SideStresses::pressure() const {
  std::vector<double> p;
  for (std::size_t k = 0; k < time.size(); ++k) p.push_back(0.5 * (xx[k] + yy[k]));
  return p;
}

std::optional<SideStresses> side_stresses(const History& history) {
  const auto* time = history.find("time");
  if (!time || time->size() < 2) return {};
  const std::size_t rows = time->size();
  for (const char* side : side_names)
    if (!history.find(std::string(side) + "_position")) return {};
  SideStresses s;
  s.time = *time;
  s.width = weighed(history, 1, "right_position", -1, "left_position", rows);
  s.height = weighed(history, 1, "top_position", -1, "bottom_position", rows);
  const auto *across_x = history.find("mean_force_x"), *across_y = history.find("mean_force_y");
  s.xx = quotient(across_x ? *across_x : weighed(history, 0.5, "left_force", 0.5, "right_force", rows), s.height);
  s.yy = quotient(across_y ? *across_y : weighed(history, 0.5, "bottom_force", 0.5, "top_force", rows), s.width);
  s.along_x = quotient(weighed(history, 0.5, "bottom_shear_force", -0.5, "top_shear_force", rows), s.width);
  s.along_y = quotient(weighed(history, 0.5, "left_shear_force", -0.5, "right_shear_force", rows), s.height);
  return s;
}

bool ends_in_motion(const dem::Stage& stage) {
  const auto is_driven = [](const dem::SideDrive& side) { return side.kind == dem::SideDrive::Kind::velocity; };
  return stage.duration || stage.strain_cycles || stage.shear_rate != 0 || std::ranges::any_of(stage.side, is_driven);
}

std::optional<texture::TimeScatter> stress_in_time(const History& history, double thickness) {
  const auto sides = side_stresses(history);
  if (!sides || sides->time.size() < 3 || !(thickness > 0)) return {};
  const auto p = sides->pressure();
  const double mean = mean_of_later(p).value;
  if (!(mean > 0)) return {};
  const double shear = deviation(sides->along_x);
  const Tensor2 pascal = 1 / thickness * Tensor2{deviation(sides->xx), shear, shear, deviation(sides->yy)};
  return texture::TimeScatter{pascal, deviation(p) / mean};
}

texture::Options texture_options(const StageResult& made) {
  texture::Options options;
  if (!made.asked.known) return options;
  options.pull = static_cast<texture::Pull>(made.asked.pull);
  options.gravity = made.asked.gravity;
  static_cast<Measuring&>(options) = made.asked.measure.value_or(Measuring{});
  if (std::isfinite(made.asked.load_axis)) options.load_axis = made.asked.load_axis;
  if (!made.asked.in_motion || made.snapshots.empty()) return options;
  const double thickness = made.snapshots.back().packing.domain.thickness;
  options.in_time = stress_in_time(made.history, thickness).value_or(texture::TimeScatter{});
  return options;
}

Numbers stage_numbers(const StageEnd& end) {
  Numbers numbers = Numbers::tree();
  for (StageStatistic* statistic : statistics) numbers.update(statistic(end));
  return numbers;
}

}  // namespace arenite::fields
