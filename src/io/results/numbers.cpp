#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/results/former_periods.hpp"
#include "io/results/groups.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

struct NumberRows {
  std::vector<std::string> name;
  std::vector<std::uint8_t> depth, kind;
  std::vector<double> value;
  std::vector<std::int64_t> worded, described, marked, periodic;  ///< rows of what is a text, has a meaning, traits, a
                                                                  ///< period
  std::vector<std::string> text, unit, sentence;
  std::vector<std::uint8_t> trait;
  std::vector<double> period;

  void transfer(const Hdf5Group& at) {
    at.texts("name", name);
    at.array("depth", depth);
    at.array("kind", kind);
    at.array("value", value, "of the name");
    transfer_some(at, "text", worded, [&](const Hdf5Group& group) { column(group, "text", text, worded); });
    transfer_some(at, "meaning", described, [&](const Hdf5Group& group) {
      column(group, "unit", unit, described);
      column(group, "sentence", sentence, described);
    });
    transfer_some(at, "trait", marked, [&](const Hdf5Group& group) { column(group, "trait", trait, marked); });
    transfer_some(at, "period", periodic, [&](const Hdf5Group& group) { column(group, "period", period, periodic); });
  }

  /// What only some rows have, as a group that lists these.
  void transfer_some(const Hdf5Group& at, const char* what, std::vector<std::int64_t>& rows,
                     const std::function<void(const Hdf5Group&)>& columns) const {
    if (at.reads() ? !at.has_group(what) : rows.empty()) return;
    const auto group = at.group(what);
    group.note("row", "index into the arrays of numbers");
    group.array("row", rows);
    columns(group);
    const bool there = rows.empty() || (rows.front() >= 0 && rows.back() < static_cast<std::int64_t>(name.size()));
    if (!std::ranges::is_sorted(rows) || !there) group.refuse("lists rows that are not there, or out of their order");
  }

  /// A text of one row widens all that stand with it.
  template <class T>
  static void column(const Hdf5Group& group, const char* name, std::vector<T>& values,
                     const std::vector<std::int64_t>& rows) {
    if constexpr (std::is_same_v<T, std::string>) group.texts(name, values);
    else group.array(name, values);
    if (values.size() != rows.size()) group.refuse("holds columns that do not agree");
  }

  /// The place of a row in such a list; nothing if it is not there.
  static std::optional<std::size_t> place_of(std::size_t row, const std::vector<std::int64_t>& rows) {
    const auto at = std::ranges::lower_bound(rows, static_cast<std::int64_t>(row));
    if (at == rows.end() || *at != static_cast<std::int64_t>(row)) return std::nullopt;
    return static_cast<std::size_t>(at - rows.begin());
  }

  void add(const std::string& path, std::uint8_t level, const Numbers& node) {
    constexpr double exact = 9007199254740992.0;  // integers beyond are kept as text
    if (const Meaning* m = node.meaning()) {
      described.push_back(static_cast<std::int64_t>(name.size()));
      unit.push_back(m->unit);
      sentence.push_back(m->sentence);
    }
    if (const Meaning* m = node.meaning(); m && m->period > 0) {
      periodic.push_back(static_cast<std::int64_t>(name.size()));
      period.push_back(m->period);
    }
    if (node.traits() != Trait::none) {
      marked.push_back(static_cast<std::int64_t>(name.size()));
      trait.push_back(static_cast<std::uint8_t>(node.traits()));
    }
    name.push_back(path);
    depth.push_back(level);
    kind.push_back(static_cast<std::uint8_t>(node.kind()));
    const bool number = node.is_number() || node.is_truth();
    value.push_back(number ? node.get<double>() : std::numeric_limits<double>::quiet_NaN());
    if (node.is_text() || (node.is_integer() && std::abs(value.back()) >= exact)) {
      worded.push_back(static_cast<std::int64_t>(name.size() - 1));
      text.push_back(node.is_text() ? node.get<std::string>() : to_json(node));
    }
    std::size_t i = 0;
    for (const Numbers& item : node) {
      const std::string& own = node.is_tree() ? node.items()[i].first : std::to_string(i);
      add(path.empty() ? own : path + "." + own, static_cast<std::uint8_t>(level + 1), item);
      ++i;
    }
  }
};

template <class T> Numbers integer_of(double value, const std::string& text) {
  return text.empty() ? static_cast<T>(value) : parse_number<T>(text).value_or(T{});
}

Numbers leaf(Numbers::Kind kind, double value, const std::string& text) {
  switch (kind) {
    case Numbers::Kind::truth: return value != 0;
    case Numbers::Kind::integer: return integer_of<std::int64_t>(value, text);
    case Numbers::Kind::natural: return integer_of<std::uint64_t>(value, text);
    case Numbers::Kind::real: return value;
    case Numbers::Kind::text: return text;
    case Numbers::Kind::list: return Numbers::list();
    case Numbers::Kind::tree: return Numbers::tree();
    case Numbers::Kind::unknown: break;
  }
  return {};
}

/// Files of versions before numbers said their periods have none.
double period_of(const NumberRows& table, std::size_t row) {
  if (table.periodic.empty()) return former_period_deg(table.name[row]);
  const auto at = NumberRows::place_of(row, table.periodic);
  return at ? table.period[*at] : 0;
}

/// Takes rows from `row` on that lie deeper than their parent.
Numbers node_at(const NumberRows& table, std::size_t& row) {
  const std::size_t own = row++;
  const auto text = NumberRows::place_of(own, table.worded), meaning = NumberRows::place_of(own, table.described),
             trait = NumberRows::place_of(own, table.marked);
  Numbers node = leaf(static_cast<Numbers::Kind>(table.kind[own]), table.value[own], text ? table.text[*text] : "");
  const std::size_t prefix = table.name[own].empty() ? 0 : table.name[own].size() + 1;
  while (row < table.name.size() && table.depth[row] == table.depth[own] + 1) {
    if (table.name[row].size() < prefix) throw NumbersError("a name is shorter than its parent's");
    const std::string name = table.name[row].substr(prefix);
    Numbers item = node_at(table, row);
    if (node.is_list()) node.push_back(std::move(item));
    else node[name] = std::move(item);
  }
  if (meaning)
    node.means({.unit = table.unit[*meaning], .sentence = table.sentence[*meaning], .period = period_of(table, own)});
  if (trait) node.mark(static_cast<Trait>(table.trait[*trait]));
  return node;
}

Numbers read_rows(const Hdf5Group& at) {
  NumberRows table;
  table.transfer(at);
  const std::size_t rows = table.name.size();
  if (rows == 0) return {};
  if (table.depth.size() != rows || table.kind.size() != rows || table.value.size() != rows || table.depth[0] != 0)
    at.refuse("holds numbers whose columns do not agree");
  std::size_t row = 0;
  try {
    Numbers numbers = node_at(table, row);
    if (row == rows) return numbers;
  } catch (const NumbersError&) {}
  at.refuse("holds numbers that are damaged");
}

void transfer_file(const Hdf5Group& at, Numbers& numbers) { transfer_numbers(at, "numbers", numbers); }

}  // namespace

void transfer_numbers(const Hdf5Group& at, const std::string& name, Numbers& numbers) {
  if (at.reads()) {
    numbers = read_rows(at.group(name));
  } else {
    NumberRows table;
    if (numbers.is_known()) table.add("", 0, numbers);
    table.transfer(at.group(name));
  }
}

void write_numbers_file(const std::filesystem::path& path, const Numbers& numbers) {
  write_result_file(path, "numbers", transfer_file, numbers);
}

Numbers read_numbers_file(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? read_result_file(path, "numbers", transfer_file) : Numbers{};
}

}  // namespace arenite::io
