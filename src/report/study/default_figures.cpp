#include "report/study/default_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

#include "core/mapped.hpp"
#include "core/text.hpp"

namespace arenite::report {
namespace {

using campaign::CollectedTable;

constexpr std::size_t most_figures = 8, most_curves = 8, most_panels = 8;

bool is_known(const CollectedTable& table, std::string_view name) { return std::ranges::count(table.names, name) > 0; }

Headlines found_of(const CollectedTable& table, const Headlines& first) {
  Headlines found;
  for (const figures::Headline& one : first)
    if (is_known(table, one.name) && !figures::is_asked_for(one.name)) found.push_back(one);
  return found;
}

/// Grains that flow under gravity fill no box whose texture would say something.
bool is_flow(const Headlines& first) {
  return std::ranges::any_of(first, [](const figures::Headline& one) {
    const std::string_view name = one.name;
    return name.starts_with("discharge.") || name.starts_with("surface.");
  });
}

/// Known numbers that the runs have beside those of their test; of a study of another kind, what it has.
std::vector<std::string> main_numbers(const CollectedTable& table, const Headlines& first) {
  std::vector<std::string> found;
  if (is_flow(first)) return found;
  for (const std::string_view name : split_blanks(figures::first_of_studies(!first.empty())))
    if (found.size() < most_figures && is_known(table, name)) found.emplace_back(name);
  for (const std::string& name : table.names)
    if (first.empty() && found.size() < 3 && std::ranges::count(found, name) == 0) found.push_back(name);
  return found;
}

bool is_number(const std::string& value) { return parse_number<double>(value).has_value(); }

/// Whether each value of one key goes with one of the other in all runs.
bool vary_together(const CollectedTable& table, std::size_t a, std::size_t b) {
  std::map<std::string, std::string> there, back;
  return std::ranges::all_of(table.rows, [&](const auto& row) {
    const std::string &one = row.values[a], &other = row.values[b];
    return there.emplace(one, other).first->second == other && back.emplace(other, one).first->second == one;
  });
}

/// Over more than a decade and without zero.
bool is_wide(const CollectedTable& table, const SweptAxis& key) {
  const auto [low, high] = std::ranges::minmax(
      mapped(table.rows, [&](const auto& row) { return parse_number<double>(row.values[key.place]).value_or(0); }));
  return low > 0 && high >= 30 * low;
}

std::string words_of(const CollectedTable::Key& key) { return key.words.empty() ? key.name : key.words; }

/// "Saturation S_m" with its index as labels have it: "Saturation S_{m}".
std::string with_indices(const std::string& words) {
  static const std::regex letter_with_index("\\b([A-Za-z])_([a-z]+)\\b");
  return std::regex_replace(words, letter_with_index, "$1_{$2}");
}

/// What a number's statistic says of it up to the first comma.
std::string words_of(const CollectedTable& table, const std::string& name) {
  const auto at = table.meanings.find(name);
  if (at == table.meanings.end()) return name;
  return with_indices(at->second.sentence.substr(0, at->second.sentence.find_first_of(",:;")));
}

std::string with_unit(const std::string& words, const std::string& unit) {
  return unit.empty() ? words : words + ", " + unit;
}

std::string words_of(const figures::Headline& one) {
  return list_of(split_blanks(fmt::format("{} {}", one.words, one.symbol)), " ");
}

/// An axis for numbers in the unit that suits the largest.
FigureAxis axis_for(const CollectedTable& table, const std::vector<std::string>& names, const std::string& label,
                    bool in_percent = false) {
  if (in_percent) return {label, false, {}, {}, "%", 0.01};
  std::vector<double> values;
  for (const std::string& name : names) {
    const auto column = static_cast<std::size_t>(std::ranges::find(table.names, name) - table.names.begin());
    for (const auto& row : table.rows)
      if (column < row.numbers.size()) values.push_back(row.numbers[column].value);
  }
  const figures::Scale scale = figures::scale_of(values, table.unit_of_number(names.front()));
  return {label, false, {}, {}, scale.unit, scale.factor};
}

std::string capital(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

/// A figure of these numbers, without its abscissa.
Figure figure_of(const CollectedTable& table, std::vector<std::string> names) {
  Figure figure;
  figure.id = names.front();
  std::ranges::replace(figure.id, '.', '-');
  if (const auto at = table.meanings.find(names.front()); at != table.meanings.end() && names.size() == 1)
    figure.caption = at->second.sentence + ".";
  figure.y = std::move(names);
  return figure;
}

/// Headlines that one axis holds, those with the same symbol: critical state and peak of q/p.
Figure figure_of(const CollectedTable& table, const Headlines& together) {
  const auto names = mapped<std::string>(together, &figures::Headline::name);
  const auto words = mapped<std::string>(together, &figures::Headline::words);
  Figure figure = figure_of(table, names);
  figure.title = capital(list_of(words, " and "));
  const auto& one = together.front();
  const bool is_alone = together.size() == 1;
  figure.y_axis = axis_for(table, names, is_alone ? words_of(one) : one.symbol, std::string_view(one.share) == "%");
  if (!is_alone) figure.names = words;
  return figure;
}

std::vector<Figure> headline_figures(const CollectedTable& table, const Headlines& found) {
  std::vector<Headlines> groups;
  for (const figures::Headline& one : found) {
    const auto like = std::ranges::find_if(groups, [&](const Headlines& group) {
      return *one.symbol && group.front().symbol == std::string_view(one.symbol) &&
             table.unit_of_number(group.front().name) == table.unit_of_number(one.name);
    });
    if (like == groups.end()) groups.push_back({one});
    else like->push_back(one);
  }
  return mapped(groups, [&](const Headlines& group) { return figure_of(table, group); });
}

/// The swept keys that tell a figure's curves and panels apart: a curve for each value of `by`, a panel for each
/// combination of the others.
struct Apart {
  std::optional<std::size_t> by;
  std::vector<std::size_t> others;
};

Apart keys_apart(const std::vector<SweptAxis>& axes) {
  Apart apart;
  for (std::size_t k = 1; k < axes.size(); ++k)
    if (axes[k].values < 2) continue;
    else if (!apart.by && axes[k].values <= most_curves) apart.by = axes[k].place;
    else apart.others.push_back(axes[k].place);
  return apart;
}

/// The combinations of these keys' values that runs have, in the order of the runs.
std::vector<std::vector<std::string>> combinations(const CollectedTable& table, const std::vector<std::size_t>& keys) {
  std::vector<std::vector<std::string>> found;
  for (const auto& row : table.rows) {
    auto one = mapped(keys, [&](std::size_t k) { return row.values[k]; });
    if (std::ranges::count(found, one) == 0) found.push_back(std::move(one));
  }
  return found;
}

/// A figure for each combination of the keys that neither axis nor curves show; points that nothing joins where these
/// would be too many.
std::vector<Figure> panels_of(const CollectedTable& table, const Figure& figure, const std::vector<std::size_t>& keys) {
  if (keys.empty()) return {figure};
  const auto all = combinations(table, keys);
  const std::string names = list_of(mapped(keys, [&](std::size_t k) { return words_of(table.keys[k]); }));
  if (all.size() > most_panels) {
    Figure points = figure;
    points.lines = false;
    points.caption += fmt::format("{}Runs of every value of {}.", points.caption.empty() ? "" : " ", names);
    return {points};
  }
  std::vector<Figure> panels;
  for (const auto& values : all) {
    Figure& panel = panels.emplace_back(figure);
    panel.id += fmt::format("-{}", panels.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const auto& key = table.keys[keys[k]];
      panel.where.push_back({key.name, {values[k]}});
      panel.title += fmt::format(", {} = {}{}{}", words_of(key), values[k], key.unit.empty() ? "" : " ", key.unit);
    }
  }
  return panels;
}

}  // namespace

std::string label_of(const CollectedTable& table, const std::string& name) {
  for (const auto& key : table.keys)
    if (key.name == name) return with_unit(words_of(key), key.unit);
  return with_unit(words_of(table, name), table.unit_of_number(name));
}

std::vector<SweptAxis> swept_axes(const CollectedTable& table) {
  std::vector<SweptAxis> axes;
  for (std::size_t k = 0; k < table.keys.size(); ++k) {
    if (table.keys[k].name == "seed") continue;
    std::set<std::string> values;
    for (const auto& row : table.rows) values.insert(row.values[k]);
    axes.push_back({k, {}, values.size(), std::ranges::all_of(values, is_number)});
  }
  std::ranges::stable_sort(axes, [](const SweptAxis& a, const SweptAxis& b) {
    return a.is_numeric != b.is_numeric ? a.is_numeric : a.values > b.values;
  });
  std::vector<SweptAxis> apart;
  for (const SweptAxis& axis : axes) {
    const auto same =
        std::ranges::find_if(apart, [&](const SweptAxis& one) { return vary_together(table, one.place, axis.place); });
    if (same == apart.end()) apart.push_back(axis);
    else same->with.push_back(words_of(table.keys[axis.place]));
  }
  return apart;
}

std::vector<Figure> default_figures(const CollectedTable& table, const Headlines& first) {
  const auto axes = swept_axes(table);
  if (axes.empty() || !axes.front().is_numeric || axes.front().values < 2) return {};
  const Headlines found = found_of(table, first);
  std::vector<Figure> figures = headline_figures(table, found);
  for (const std::string& name : main_numbers(table, found)) {
    Figure& figure = figures.emplace_back(figure_of(table, std::vector{name}));
    figure.title = words_of(table, name);
    figure.y_axis = axis_for(table, {name}, figure.title);
  }
  const auto& key = table.keys[axes.front().place];
  const FigureAxis axis{words_of(key), is_wide(table, axes.front()), {}, {}, key.unit};
  const Apart apart = keys_apart(axes);
  std::vector<Figure> panels;
  for (Figure& figure : figures) {
    figure.x = key.name;
    figure.x_axis = axis;
    if (const auto& with = axes.front().with; !with.empty())
      figure.caption += fmt::format("{}With {} goes {}.", figure.caption.empty() ? "" : " ", axis.label, list_of(with));
    if (apart.by) figure.by = table.keys[*apart.by].name, figure.by_label = words_of(table.keys[*apart.by]);
    std::ranges::move(panels_of(table, figure, apart.others), std::back_inserter(panels));
  }
  return panels;
}

Numbers runs_table(const CollectedTable& table, const Headlines& first,
                   const std::function<std::string(const std::string& run)>& link) {
  const Headlines found = found_of(table, first);
  std::vector<std::string> numbers = mapped<std::string>(found, &figures::Headline::name);
  std::vector<std::string> heads = mapped(found, [&](const figures::Headline& one) {
    return capital(with_unit(words_of(one), table.unit_of_number(one.name)));
  });
  for (const std::string& name : main_numbers(table, found)) {
    numbers.push_back(name);
    heads.push_back(label_of(table, name));
  }
  const auto columns = mapped(numbers, [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(table.names, name) - table.names.begin());
  });
  const auto row_of = [&](const CollectedTable::Row& row) {
    const auto number_in = [&](std::size_t c) {
      const auto number = c < row.numbers.size() ? row.numbers[c] : statistics::Estimate();
      return std::isfinite(number.value) ? Numbers{number.value, number.error} : Numbers();
    };
    return Numbers{{"run", row.run},
                   {"status", row.status},
                   {"link", link ? link(row.run) : ""},
                   {"values", row.values},
                   {"numbers", mapped(columns, number_in)}};
  };
  return {{"keys", mapped(table.keys, [&](const auto& key) { return label_of(table, key.name); })},
          {"names", heads},
          {"rows", mapped(table.rows, row_of)}};
}

}  // namespace arenite::report
