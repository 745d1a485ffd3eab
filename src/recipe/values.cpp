#include "recipe/values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"
#include "recipe/document.hpp"
#include "recipe/quantities.hpp"
#include "recipe/record.hpp"
#include "recipe/series_file.hpp"

namespace arenite::recipe {
namespace {

/// In brackets; nothing without items.
template <class Items, class Literal> std::optional<std::string> list_literal(const Items& items, Literal literal) {
  if (items.empty()) return std::nullopt;
  return fmt::format("[{}]", list_of(mapped(items, literal)));
}

template <int D>
Record record_of_rows(const Key& key, const std::vector<Vec<D>>& rows, const std::array<std::string_view, D>& unit,
                      const std::string& example) {
  const auto row_of = [&](const auto& number) {
    std::array<std::string, D> row;
    for (std::size_t n = 0; n < D; ++n) row[n] = number(n);
    return fmt::format("[{}]", list_of(row));
  };
  const auto form = fmt::format("[{}, ...]", row_of([&](std::size_t n) { return with_unit("...", unit[n]); }));
  Record record{key, form, {}, Record::Type::other, {}, example};
  record.literal = list_literal(rows, [&](Vec<D> row) {
    return row_of([&](std::size_t n) { return number_literal(row[static_cast<int>(n)], unit[n]); });
  });
  return record;
}

bool is_number(const Node& node) { return node.kind == Node::Kind::integer || node.kind == Node::Kind::real; }

std::optional<double> read_number(const Written& at, std::string_view unit, const Range& range) {
  const Node& node = at.node;
  const Dimension wanted = dimension_of(unit);
  double value = 0;
  if (node.kind == Node::Kind::text) {
    try {
      value = si_value(node.text, wanted, unit, at.reading.variables);
    } catch (const InputError& error) { return at.refuse(error.what()); }
  } else {
    if (!at.is(is_number(node), "a number, such as " + with_unit(unit.empty() ? "0.5" : "1", unit)))
      return std::nullopt;
    value = node.kind == Node::Kind::integer ? static_cast<double>(node.integer) : node.real;
    if (!std::isfinite(value)) return at.refuse("must be a finite number");
    if (!is_in_reach(value))
      return at.refuse(fmt::format("{} is beyond the range of numbers; write 0 or a magnitude from 1e-60 to 1e60",
                                   as_written(node)));
    const bool lacks_unit = wanted != dimension::none || unit == "deg";
    if (lacks_unit && !at.reading.bare_numbers_are_si) return at.refuse(unit_is_missing(node, unit));
  }
  if (range.contains(value)) return value;
  return at.refuse(fmt::format("{} is out of range; it must be {}", as_written(node), to_string(range, unit)));
}

template <class T, class Read> void read_items(const Written& list, std::vector<T>& values, Read read) {
  values.clear();
  for (std::size_t i = 0; i < list.node.items.size(); ++i)
    if (const std::optional<T> item = read(list.item(i))) values.push_back(*item);
}

template <int D>
void read_rows(const Written& list, std::vector<Vec<D>>& rows, const std::array<std::string_view, D>& unit,
               const std::string& wanted) {
  read_items(list, rows, [&](const Written& row) -> std::optional<Vec<D>> {
    if (row.node.kind != Node::Kind::array || row.node.items.size() != unit.size())
      return list.refuse(row.node.place, wanted);
    std::array<std::optional<double>, D> read;
    for (std::size_t n = 0; n < unit.size(); ++n) read[n] = read_number(row.item(n), unit[n], range::any);
    if (!std::ranges::all_of(read, [](const auto& number) { return number.has_value(); })) return std::nullopt;
    return by_axis<D>([&](int axis) { return *read[static_cast<std::size_t>(axis)]; });
  });
}

template <int D, class Visit>
void visit_points(const Key& key, std::vector<Vec<D>>& values, std::string_view unit, const Visit& visit) {
  std::array<std::string_view, D> units;
  units.fill(unit);
  const std::string z = D == 2 ? "" : fmt::format(", \"0 {}\"", unit),
                    example = fmt::format("[[\"0 {0}\", \"0 {0}\"{1}], [\"1 {0}\", \"2 {0}\"{1}]]", unit, z);
  const char* numbers = D == 2 ? "two numbers, x and y," : "three numbers, x, y and z,";
  visit(record_of_rows<D>(key, values, units, example), [&](const Written& at) {
    if (at.is_a(Node::Kind::array, "a list of points"))
      read_rows<D>(at, values, units, fmt::format("each point must be {} such as {}", numbers, example));
  });
}

/// The entry of a table that must hold just one; of several, an override wins over the file.
const Entry* only_entry(const Node& table) {
  if (table.entries.size() == 1) return &table.entries.front();
  const auto wins = [](const Entry& entry) { return entry.value.place.wins; };
  return std::ranges::count_if(table.entries, wins) == 1 ? &*std::ranges::find_if(table.entries, wins) : nullptr;
}

std::string form_literal(const Form& form, const std::string& quantity) {
  return form.unit.empty() ? toml_text(form.word) : fmt::format("{{ {} = {} }}", form.word, quantity);
}

void read_form(const Written& at, int& form, double& value, const std::vector<Form>& forms) {
  const Node& node = at.node;
  const std::string ways =
      list_of(mapped(forms, [](const Form& each) { return form_literal(each, with_unit("1", each.unit)); }));
  const bool is_bare = node.kind == Node::Kind::text;
  const Entry* const only = node.kind == Node::Kind::table ? only_entry(node) : nullptr;
  if (!only && node.entries.size() > 1)
    return void(at.refuse(
        fmt::format("is given as {}; keep one of them", list_of(mapped(node.entries, &Entry::key), " and "))));
  if (!is_bare && !only) return void(at.refuse("must be one of: " + ways));
  const std::string &word = is_bare ? node.text : only->key, path = at.path + "." + word;
  std::vector<std::string> alike;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (forms[i].unit.empty() != is_bare) continue;
    alike.emplace_back(forms[i].word);
    if (forms[i].word != word) continue;
    const std::optional<double> read =
        is_bare ? 0 : read_number({only->value, path, at.reading}, forms[i].unit, forms[i].range);
    if (read) form = static_cast<int>(i), value = *read;
    return;
  }
  const std::string near = nearest(word, alike), tag = tag_of_quantity(word, forms);
  if (!is_bare)
    return at.reading.add(
        only->place, path,
        near.empty() ? "unknown key; write one of: " + ways : fmt::format("unknown key; did you mean {}?", near));
  at.refuse(!tag.empty()   ? fmt::format("write {{ {} = \"{}\" }}", tag, word)
            : near.empty() ? fmt::format("unknown word \"{}\"; write one of: {}", word, ways)
                           : fmt::format("unknown word \"{}\"; did you mean \"{}\"?", word, near));
}

}  // namespace

void KeyVisitor::number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) {
  Record record{key, with_unit("...", unit), to_string(range, unit), Record::Type::number, unit};
  if (value) record.literal = number_literal(*value, unit);
  visit(std::move(record), [&](const Written& at) {
    if (const auto read = read_number(at, unit, range)) value = read;
  });
}

void KeyVisitor::integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) {
  Record record{key, "...", to_string(range), Record::Type::integer};
  record.integers = range;
  if (value) record.literal = std::to_string(*value);
  visit(std::move(record), [&](const Written& at) {
    Node node = at.node;
    if (node.kind == Node::Kind::text && is_expression(node.text, at.reading.variables)) {
      const auto found = read_number(at, "", range::any);
      if (!found) return;
      node.kind = Node::Kind::real, node.real = nearest_whole(*found);
    }
    const auto read = whole_number(node);
    if (is_beyond_integers(node))
      at.refuse(fmt::format("{} is out of range; it must be from {} to {}", node.text, range.min, range.max));
    else if (!at.is(is_number(node), "a whole number")) return;
    else if (!read) at.refuse(fmt::format("{} is not a whole number", as_written(node)));
    else if (*read < range.min || *read > range.max)
      at.refuse(fmt::format("{} is out of range; it must be {}", *read, to_string(range)));
    else value = read;
  });
}

void KeyVisitor::flag(const Key& key, bool& value) {
  visit({.key = key, .form = "true", .type = Record::Type::flag, .literal = value ? "true" : "false"},
        [&](const Written& at) {
          if (at.is_a(Node::Kind::flag, "true or false (without quotes)")) value = at.node.flag;
        });
}

void KeyVisitor::text(const Key& key, std::string& value) { visit_text(key, value, false); }
void KeyVisitor::file(const Key& key, std::string& value) { visit_text(key, value, true); }

void KeyVisitor::visit_text(const Key& key, std::string& value, bool names_file) {
  Record record{key, "\"...\"", {}, Record::Type::text};
  if (!value.empty() || key.required) record.literal = toml_text(value);
  visit(std::move(record), [&](const Written& at) {
    if (!at.is_a(Node::Kind::text, "a text in quotes")) return;
    value = at.node.text;
    if (std::error_code error; names_file && at.reading.look_for_files &&
                               !std::filesystem::exists(std::filesystem::path(at.reading.folder) / value, error))
      at.refuse(fmt::format("there is no file \"{}\"; paths are relative to the folder of the recipe", value));
  });
}

void KeyVisitor::numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) {
  const std::string each = to_string(range, unit), form = fmt::format("[{}]", with_unit("...", unit)),
                    example = fmt::format("[{}, {}]", with_unit("1", unit), with_unit("2", unit));
  Record record{key, form, each.empty() ? "" : "each " + each, Record::Type::numbers, unit, example};
  record.literal = list_literal(values, [&](double value) { return number_literal(value, unit); });
  visit(std::move(record), [&](const Written& at) {
    if (at.is_a(Node::Kind::array, "a list"))
      read_items(at, values, [&](const Written& item) { return read_number(item, unit, range); });
  });
}

void KeyVisitor::texts(const Key& key, std::vector<std::string>& values) {
  Record record{key, "[\"...\"]", {}, Record::Type::other, {}, "[\"a\", \"b\"]"};
  record.literal = list_literal(values, toml_text);
  visit(std::move(record), [&](const Written& at) {
    const auto text = [&](const Written& item) {
      return item.is_a(Node::Kind::text, "a text in quotes") ? std::optional(item.node.text) : std::nullopt;
    };
    if (at.is_a(Node::Kind::array, "a list of texts in quotes")) read_items(at, values, text);
  });
}

void KeyVisitor::wanted(const Key& key, Wanted& values) {
  const auto written = [](const Node& node) { return node.kind == Node::Kind::text ? node.text : toml_literal(node); };
  Record record{key, "{ KEY = VALUE }", {}, Record::Type::other, {}, "{ \"cement.kind\" = \"full\" }"};
  if (!values.empty())
    record.literal =
        fmt::format("{{ {} }}", list_of(mapped(values, [](const auto& each) {
                      return fmt::format("{} = [{}]", toml_key(each.first), list_of(mapped(each.second, toml_text)));
                    })));
  visit(std::move(record), [&](const Written& at) {
    values.clear();
    if (!at.is_a(Node::Kind::table, "a table of keys and values")) return;
    for (const Entry& entry : at.node.entries) {
      const Node& value = entry.value;
      values.emplace_back(entry.key,
                          value.kind == Node::Kind::array ? mapped(value.items, written) : std::vector{written(value)});
    }
  });
}

void KeyVisitor::pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) {
  Record record{key, "[[0, 1], ...]", {}, Record::Type::other, {}, "[[0, 1], [1, 2]]"};
  record.literal =
      list_literal(values, [](const auto& pair) { return fmt::format("[{}, {}]", pair.first, pair.second); });
  visit(std::move(record), [&](const Written& at) {
    const auto is_index = [](const Node& n) {
      return n.kind == Node::Kind::integer && n.integer >= 0 && n.integer <= INT32_MAX;
    };
    const auto pair = [&](const Written& item) -> std::optional<std::pair<std::int32_t, std::int32_t>> {
      const auto& two = item.node.items;
      if (item.node.kind == Node::Kind::array && two.size() == 2 && std::ranges::all_of(two, is_index) &&
          two[0].integer != two[1].integer)
        return std::pair(static_cast<std::int32_t>(two[0].integer), static_cast<std::int32_t>(two[1].integer));
      return at.refuse(item.node.place, "each pair must be two different grain indices from 0, such as [0, 1]");
    };
    if (at.is_a(Node::Kind::array, "a list of pairs")) read_items(at, values, pair);
  });
}

void KeyVisitor::points(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  visit_points(key, values, unit, std::bind_front(&KeyVisitor::visit, this));
}
void KeyVisitor::points(const Key& key, std::vector<Vec3>& values, std::string_view unit) {
  visit_points(key, values, unit, std::bind_front(&KeyVisitor::visit, this));
}

void KeyVisitor::series(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  const std::string example = fmt::format("[[\"0 s\", {0}], [\"1 s\", {0}]]", with_unit("1", unit));
  visit(record_of_rows<2>(key, values, {"s", unit}, example), [&](const Written& at) {
    values.clear();
    if (at.node.kind == Node::Kind::text) read_series_file(at, values, unit);
    else if (at.is_a(Node::Kind::array, fmt::format("a list such as {} or the name of a CSV file", example)))
      read_rows<2>(at, values, {"s", unit}, fmt::format("each row must be a time and a value, such as {}", example));
  });
}

void KeyVisitor::choice(const Key& key, int& index, const std::vector<Word>& words) {
  const auto names = mapped<std::string>(words, &Word::word);
  Record record{key, "\"...\"", {}, Record::Type::choice};
  for (const auto& word : words) record.choices.push_back({toml_text(word.word), std::string(word.sentence), word});
  record.literal = record.choices[static_cast<std::size_t>(index)].literal;
  visit(std::move(record), [&](const Written& at) {
    if (!at.is_a(Node::Kind::text, "one of: " + list_of(names))) return;
    const auto found = std::ranges::find(names, at.node.text);
    if (found != names.end()) return void(index = static_cast<int>(found - names.begin()));
    const std::string near = nearest(at.node.text, names);
    at.refuse(fmt::format("unknown word \"{}\"; {}it must be one of: {}", at.node.text,
                          near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near), list_of(names)));
  });
}

void KeyVisitor::tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) {
  Record record{key, "..."};
  for (const auto& each : forms)
    record.choices.push_back({form_literal(each, with_unit("...", each.unit)), std::string(each.sentence)});
  const Form& chosen = forms[static_cast<std::size_t>(form)];
  record.literal = form_literal(chosen, number_literal(value, chosen.unit));
  visit(std::move(record), [&](const Written& at) { read_form(at, form, value, forms); });
}

}  // namespace arenite::recipe
