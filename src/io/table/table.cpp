#include "io/table/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/text.hpp"
#include "core/unit_names.hpp"

namespace arenite::io {
namespace {

/// Without the quotes around a cell; a doubled quote inside stays as it is written.
std::string_view unquoted(std::string_view cell) {
  return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

/// Whether a spreadsheet takes this text for a formula: it begins with a sign for one, or as a number that goes on with
/// a call.
bool is_formula(std::string_view text) {
  if (text.empty()) return false;
  if (text.front() == '=' || text.front() == '@' || text.front() == '\t' || text.front() == '\r') return true;
  return (text.front() == '+' || text.front() == '-') && text.find_first_of("(|!=") != std::string_view::npos;
}

/// "sep=;", by which spreadsheets say how the cells of the lines below are separated; 0 for any other line.
char stated_separator(std::string_view line) {
  line = unquoted(trimmed(line));
  const bool is = line.size() == 5 && lower_case(line.substr(0, 4)) == "sep=";
  return is ? line.back() : lower_case(line) == "sep=" ? '\t' : '\0';
}

char separator_of(std::string_view line) {
  for (const char c : {',', ';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// "x [mm]", "x (mm)" -> x, mm.
Table::Column column_of(std::string_view cell) {
  const auto open = cell.find_first_of("[(");
  const bool closed = open != std::string_view::npos && (cell.back() == ']' || cell.back() == ')');
  const auto name = trimmed(closed ? cell.substr(0, open) : cell);
  return {lower_case(name), std::string(closed ? trimmed(cell.substr(open + 1, cell.size() - open - 2)) : ""),
          std::string(name)};
}

bool is_unit(std::string_view cell) {
  if (cell.empty() || cell == "-" || cell == "px") return true;
  if (to_number(cell)) return false;
  try {
    parse_unit(cell);
    return true;
  } catch (const InputError&) { return false; }
}

/// A row of units holds no number at all: "1" is a number, "-" stands for no unit.
bool is_unit_row(const Table::Row& row) { return std::all_of(row.cells.begin(), row.cells.end(), is_unit); }

void check_header(const Table& table, int line, Problems& problems) {
  for (std::size_t a = 0; a < table.columns.size(); ++a)
    for (std::size_t b = a + 1; b < table.columns.size(); ++b)
      if (!table.columns[a].name.empty() && table.columns[a].name != "-" &&
          table.columns[a].name == table.columns[b].name)
        problems.add(line, "column \"{}\" appears twice; rename or drop one", table.columns[a].name);
}

bool is_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The digits behind the comma of a number such as "-12,5" or "1,5e-3"; nothing of any other cell.
std::optional<std::string_view> behind_comma(std::string_view cell) {
  const auto comma = cell.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  std::string_view whole = cell.substr(0, comma), rest = cell.substr(comma + 1);
  if (whole.starts_with('-') || whole.starts_with('+')) whole.remove_prefix(1);
  std::string number = "0." + std::string(rest);
  if (!is_digits(whole) || rest.empty() || !is_digits(rest.substr(0, 1)) || !to_number(number)) return std::nullopt;
  return rest.substr(0, std::min(rest.find_first_of("eEdD"), rest.size()));
}

/// Cells whose numbers have decimal commas get points, where that is what the commas are: not beside numbers with
/// points, and where blanks or tabs separate, not where each comma may separate thousands.
void take_decimal_commas(Table& table, char separator, Problems& problems) {
  bool telling = separator == ';', points = false;
  const Table::Row* first = nullptr;
  std::string_view example;
  for (const Table::Row& row : table.rows)
    for (const std::string_view cell : row.cells) {
      points = points || (cell.find('.') != std::string_view::npos && to_number(cell));
      const auto digits = behind_comma(cell);
      if (!digits) continue;
      telling = telling || digits->size() != 3;
      if (first == nullptr) first = &row, example = cell;
    }
  if (first == nullptr) return;
  if (points || !telling)
    return problems.add(first->line,
                        "\"{}\" may be a number with a decimal comma or with thousands set apart{}; write decimal "
                        "points and no other signs in numbers",
                        example, points ? ", and others have points" : "");
  table.rewritten = std::make_shared<std::deque<std::string>>();
  for (Table::Row& row : table.rows)
    for (std::string_view& cell : row.cells) {
      if (!behind_comma(cell)) continue;
      table.rewritten->emplace_back(cell);
      std::ranges::replace(table.rewritten->back(), ',', '.');
      cell = table.rewritten->back();
    }
}

/// The names behind the sign of a comment, where a row of numbers below it has as many cells: the header as
/// numpy.savetxt writes it. Empty where it holds none.
std::vector<std::string_view> names_in_comment(std::string_view comment, char separator, std::size_t cells) {
  comment = trimmed(comment);
  while (comment.starts_with('#') || comment.starts_with('%')) comment = trimmed(comment.substr(1));
  if (comment.empty()) return {};
  for (const char by : {separator, separator_of(comment)}) {
    auto names = split_cells(comment, by);
    const auto is_name = [](std::string_view name) { return !name.empty() && !to_number(name); };
    if (names.size() == cells && std::ranges::all_of(names, is_name)) return names;
  }
  return {};
}

/// The problem of a row that has not a cell for each column.
std::string ragged(const Table::Row& row, std::size_t columns, char separator) {
  const bool more = separator == ',' && row.cells.size() > columns;
  return fmt::format("this row has {} cells, but there are {} columns; complete or remove it{}", row.cells.size(),
                     columns, more ? ", and if its commas are decimal ones, separate cells by semicolons" : "");
}

}  // namespace

/// Cuts at separators that are not inside quotes.
std::vector<std::string_view> split_cells(std::string_view line, char separator) {
  if (separator == ' ') return split_blanks(line);
  std::vector<std::string_view> cells;
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') quoted = !quoted;
    if (at < line.size() && (quoted || line[at] != separator)) continue;
    std::string_view cell = unquoted(trimmed(line.substr(start, at - start)));
    if (cell.starts_with('\'') && is_formula(cell.substr(1))) cell.remove_prefix(1);
    cells.push_back(cell);
    start = at + 1;
  }
  return cells;
}

std::string quoted_cell(const std::string& text) {
  if (is_formula(text)) return quoted_cell('\'' + text);
  if (text.find_first_of(",;\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const auto end = std::min(rest_.find('\n'), rest_.size());
  line = rest_.substr(0, end);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

std::optional<std::size_t> Table::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names)
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].name == name) return c;
  return std::nullopt;
}

Table read_table(std::string_view text, const std::string& columns, Problems& problems) {
  Table table;
  char separator = 0;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (const std::string_view name : columns.empty() ? std::vector<std::string_view>{} : split_cells(columns, ','))
    table.columns.push_back(column_of(name));
  check_header(table, 0, problems);
  Lines lines(text);
  bool first_row = true;
  std::string_view comment;  // the last one
  int comment_line = 0;
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    if (trimmed(line).front() == '#' || trimmed(line).front() == '%') {
      comment = line;
      comment_line = lines.number();
      continue;
    }
    if (separator == 0 && (separator = stated_separator(line)) != 0) continue;
    if (separator == 0) separator = separator_of(line);
    Table::Row row{lines.number(), split_cells(line, separator)};
    if (table.columns.empty() && to_number(row.cells.front())) {
      for (const std::string_view name : names_in_comment(comment, separator, row.cells.size())) {
        table.header_line = comment_line;
        table.columns.push_back(column_of(name));
      }
      check_header(table, comment_line, problems);
    }
    if (table.columns.empty()) {
      table.header_line = row.line;
      for (const std::string_view cell : row.cells) table.columns.push_back(column_of(cell));
      check_header(table, row.line, problems);
      if (to_number(row.cells.front()))
        problems.add(row.line,
                     "the first row must name the columns, but it holds numbers; add a header such as \"id,x [mm],y "
                     "[mm],radius [mm]\" or name the columns on the command line");
      continue;
    }
    if (row.cells.size() != table.columns.size()) {
      problems.add(row.line, ragged(row, table.columns.size(), separator));
      continue;
    }
    if (first_row && is_unit_row(row)) {
      for (std::size_t c = 0; c < row.cells.size(); ++c)
        if (table.columns[c].unit.empty() && row.cells[c] != "-") table.columns[c].unit = row.cells[c];
    } else {
      table.rows.push_back(std::move(row));
    }
    first_row = false;
  }
  if (table.columns.empty()) problems.add("the file is empty; give a header row and one row per item");
  take_decimal_commas(table, separator, problems);
  return table;
}

std::optional<double> to_number(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  auto value = parse_number<double>(cell);
  if (const auto exponent = cell.find_first_of("dD"); !value && exponent != std::string_view::npos) {
    std::string number(cell);
    number[exponent] = 'e';
    value = parse_number<double>(number);
  }
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> to_integer(std::string_view cell) {
  if (const auto value = parse_number<std::int64_t>(cell)) return value;
  const auto number = to_number(cell);  // "42.0" and "4.2e1" name grain 42 too
  if (!number || *number != std::floor(*number) || std::abs(*number) > 9e15) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

bool is_celsius(std::string_view unit) { return unit == "C" || unit == "degC" || unit == "\u00b0C"; }

double unit_factor(std::string_view unit, Dimension dimension) {
  const Unit u = parse_unit(unit);
  if (!(u.dimension == dimension))
    throw InputError(
        fmt::format("\"{}\" is not {}; use a unit such as {}", unit, describe(dimension), si_unit(dimension)));
  return u.decade < 0 ? u.factor / std::pow(10.0, -u.decade) : u.factor * std::pow(10.0, u.decade);
}

double factor_or_problem(std::string_view unit, const std::string& column, Dimension dimension, double otherwise,
                         int line, Problems& problems) {
  try {
    return unit.empty() ? otherwise : unit_factor(unit, dimension);
  } catch (const InputError& error) {
    problems.add(line, "column {}: {}", column, error.problems().front().message);
    return otherwise;
  }
}

double number_or_problem(std::string_view cell, const std::string& column, double factor, int line,
                         Problems& problems) {
  if (const auto value = to_number(cell)) return *value * factor;
  problems.add(line, "{} is \"{}\", which is not a finite number; correct it or remove the row", column, cell);
  return 0;
}

std::int64_t integer_or_problem(std::string_view cell, const std::string& column, int line, Problems& problems) {
  if (const auto value = to_integer(cell)) return *value;
  problems.add(line, "{} is \"{}\", which is not a whole number; give the number of a grain", column, cell);
  return 0;
}

}  // namespace arenite::io
