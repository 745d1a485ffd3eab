#include "statistics/numbers_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "statistics/numbers.hpp"
#include "statistics/written.hpp"

namespace arenite {
namespace {

constexpr std::size_t most_items = 4, longest_text = 80;

double largest_of(const Numbers& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double largest = 0;
  for (const Numbers& item : value) largest = std::max(largest, largest_of(item));
  return largest;
}

/// A number with its error, or the items of a tensor: one after the other, rows parted by semicolons. Empty for what is
/// no number.
std::string number_text(const Numbers& value, const Numbers* error, double scale) {
  if (value.is_integer()) return to_json(value);
  if (value.is_real()) {
    const double number = scale * value.get<double>();
    return error && error->is_number() ? statistics::with_error({number, scale * error->get<double>()})
                                       : fmt::format("{:.5g}", number + 0.0);
  }
  if (!value.is_list() || value.empty() || value.size() > most_items) return {};
  std::vector<std::string> items;
  for (std::size_t i = 0; i < value.size(); ++i) {
    items.push_back(
        number_text(value[i], error && error->is_list() && i < error->size() ? &(*error)[i] : nullptr, scale));
    if (items.back().empty()) return {};
  }
  return fmt::format("{}", list_of(items, value.front().is_list() ? "; " : ", "));
}

/// "0.842 +- 0.003 N"; stresses in the unit that suits them. Empty for groups, curves and what is not known.
std::string value_text(const Numbers& node, const std::string& unit) {
  if (node.is_truth()) return node.get<bool>() ? "yes" : "no";
  if (node.is_text()) {
    std::string text = node.get<std::string>();
    return text.size() > longest_text || text.find('\n') != std::string::npos ? std::string() : text;
  }
  const bool is_estimate = node.is_tree() && node.contains("value");
  const Numbers& value = is_estimate ? node["value"] : node;
  const auto [factor, prefixed] =
      unit == "Pa" ? statistics::scale_of(largest_of(value), unit) : statistics::Scale{1, unit};
  const double scale = 1 / factor;
  std::string text = number_text(value, is_estimate ? node.at_path("/error") : nullptr, scale);
  if (text.empty()) return text;
  if (!prefixed.empty()) text += fmt::format(" {}", prefixed);
  if (is_estimate && node.contains("low_95") && node["low_95"].is_number())
    text += fmt::format(" (95 %: {:.4g} to {:.4g})", scale * node["low_95"].get<double>(),
                        scale * node["high_95"].get<double>());
  return text;
}

std::string row(const std::string& name, const Numbers& node, const Meaning* meaning) {
  const std::string value = value_text(node, meaning ? meaning->unit : "");
  if (value.empty()) return value;
  std::string line = fmt::format("  {:<32} {:<22}  {}", name, value, meaning ? meaning->sentence : "");
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

bool is_left_out(const std::string& name, const LeftOut& left_out) {
  const auto names = split_blanks(left_out.names), endings = split_blanks(left_out.endings);
  return std::ranges::count(names, name) > 0 ||
         std::ranges::any_of(endings, [&](std::string_view end) { return name.ends_with(fmt::format(" {}", end)); });
}

/// Whether a set is all of what it is a part of: both begin with the same count.
bool repeats(const Numbers& set, const Numbers& whole) {
  return set.is_tree() && !set.empty() && whole.is_tree() && set.front().is_integer() && set.front() == whole.front();
}

std::string joined(const std::string& name, const std::string& own) { return name.empty() ? own : name + "." + own; }

struct Table {
  LeftOut left_out;
  std::string rows, notes;

  void add(const std::string& name, const Numbers& node, const Meaning* of_group, const Numbers& whole) {
    const Meaning* meaning = node.meaning() ? node.meaning() : of_group;
    const std::string own_row = row(name, node, meaning);
    rows += own_row;
    if (!own_row.empty() || !node.is_tree()) return;
    for (const auto& [own, item] : node.items()) {
      if (is_left_out(own, left_out) || repeats(item, whole)) continue;
      if (item.is_list() && !item.empty() && item.front().is_text())
        for (const Numbers& note : item) notes += "  note: " + note.get<std::string>() + "\n";
      else add(joined(name, own), item, meaning, node);
    }
  }

  /// What lies at a path from a node of this name.
  void add_at(std::string_view path, const std::string& name, const Numbers& node, const Meaning* of_group) {
    const Meaning* meaning = node.meaning() ? node.meaning() : of_group;
    if (path.empty()) return add(name, node, meaning, {});
    const std::string_view step = path.substr(0, path.find('.'));
    for (const auto& [own, item] : node.items())
      if (step == own || (step.ends_with('*') && own.starts_with(step.substr(0, step.size() - 1))))
        add_at(path.substr(std::min(path.size(), step.size() + 1)), joined(name, own), item, meaning);
  }
};

}  // namespace

std::string to_text(const Numbers& tree, const LeftOut& left_out) {
  Table table{left_out, {}, {}};
  table.add("", tree, nullptr, {});
  return table.rows + table.notes;
}

std::string rows_of(const Numbers& tree, std::string_view names) {
  Table table{{}, {}, {}};
  for (const std::string_view name : split_blanks(names)) table.add_at(name, "", tree, nullptr);
  return table.rows;
}

std::string statistics::with_error(const Estimate& e, double scale) {
  const double value = e.value * scale, error = e.error * scale;
  if (!std::isfinite(error)) return fmt::format("{:.4g}", value);
  if (error <= 1e-12 * std::abs(value)) return fmt::format("{:.6g}", value);
  if (error < 1e-4 || error >= 1e5 || std::abs(value) >= 1e6) return fmt::format("{:.4g} +- {:.2g}", value, error);
  const int places = std::max(0, decimals_of(error));
  return fmt::format("{:.{}f} +- {:.{}f}", value, places, error, places);
}

}  // namespace arenite
