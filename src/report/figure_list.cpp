#include "report/figure_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "recipe/recipe_document.hpp"

namespace arenite::report {
namespace {

using study::Entry;
using study::Node;
using Kind = Node::Kind;

bool is_number(const Node& node) { return node.kind == Kind::integer || node.kind == Kind::real; }

double number_of(const Node& node) { return node.kind == Kind::integer ? static_cast<double>(node.integer) : node.real; }

/// Reads the keys of one table; what is left over is unknown.
class Table {
 public:
  Table(const Node& node, const std::string& file, std::vector<Problem>& problems) : node_(node), file_(file), problems_(problems) {}

  void text(const char* key, std::string& value, bool needed = false) {
    const Entry* entry = take(key);
    if (entry && entry->value.kind == Kind::text) value = entry->value.text;
    else if (entry) refuse(entry->value, key, "is a text in quotes");
    else if (needed) refuse(node_, key, "is missing");
  }
  void flag(const char* key, bool& value) {
    const Entry* entry = take(key);
    if (entry && entry->value.kind == Kind::flag) value = entry->value.flag;
    else if (entry) refuse(entry->value, key, "is true or false");
  }
  void number(const char* key, std::optional<double>& value) {
    const Entry* entry = take(key);
    if (entry && is_number(entry->value)) value = number_of(entry->value);
    else if (entry) refuse(entry->value, key, "is a number");
  }
  void texts(const char* key, std::vector<std::string>& values) {
    const Entry* entry = take(key);
    if (!entry) return;
    if (entry->value.kind != Kind::array) return refuse(entry->value, key, "is a list of texts");
    for (const Node& item : entry->value.items) {
      if (item.kind == Kind::text) values.push_back(item.text);
      else refuse(item, key, "is a list of texts");
    }
  }
  void numbers(const char* key, std::vector<double>& values) {
    const Entry* entry = take(key);
    if (!entry) return;
    if (entry->value.kind != Kind::array) return refuse(entry->value, key, "is a list of numbers");
    for (const Node& item : entry->value.items) {
      if (is_number(item)) values.push_back(number_of(item));
      else refuse(item, key, "is a list of numbers");
    }
  }
  const Entry* take(const char* key) {
    known_.insert(key);
    return node_.find(key);
  }
  void refuse_unknown() {
    for (const Entry& entry : node_.entries)
      if (!known_.contains(entry.key)) problems_.push_back({file_, entry.place.line, entry.place.column, fmt::format("`{}` is no key of a figure", entry.key)});
  }
  void refuse(const Node& node, const std::string& key, const std::string& message) {
    problems_.push_back({file_, node.place.line, node.place.column, fmt::format("`{}` {}", key, message)});
  }

 private:
  const Node& node_;
  const std::string& file_;
  std::vector<Problem>& problems_;
  std::set<std::string, std::less<>> known_;
};

constexpr std::array words = {"plot", "rose", "map", "grains", "forces", "stresses", "film", "phases", "zoom", "cracks"};

void read_kind(Table& table, const Node& node, Figure& figure) {
  std::string word = word_for(figure.kind);
  table.text("kind", word);
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.end()) return table.refuse(node, "kind", fmt::format("is one of {}", fmt::join(words, ", ")));
  figure.kind = static_cast<FigureKind>(at - words.begin());
}

void read_spread(Table& table, const Node& node, Figure& figure) {
  std::string word = "error";
  table.text("spread", word);
  if (word == "deviation") figure.spread = Spread::deviation;
  else if (word != "error") table.refuse(node, "spread", "is \"error\" or \"deviation\"");
}

/// What the kind of figure needs.
void check_figure(Table& table, const Node& node, const Figure& figure) {
  const bool points = !figure.x.empty() && !figure.y.empty();
  if (figure.kind == FigureKind::plot && figure.curves.empty() && !points) table.refuse(node, "x", "and `y` say what is drawn, or `curves`");
  if (figure.kind == FigureKind::rose && figure.curves.empty()) table.refuse(node, "curves", "say what a rose shows");
  if (figure.kind == FigureKind::map && (!points || figure.by.empty() || figure.y.size() != 1)) table.refuse(node, "x", ", `by` and one `y` say what a map shows");
  if (const std::size_t n = figure.curves.empty() ? figure.y.size() : figure.curves.size(); !figure.names.empty() && figure.names.size() != n)
    table.refuse(node, "names", fmt::format("must be as many as what is drawn: {}", n));
  if (const double n = figure.sectors.value_or(18); !(n >= 2 && n <= 360 && n == std::floor(n))) table.refuse(node, "sectors", "is a whole number, 2 to 360");
  if (const double share = figure.window.value_or(1); !(share > 0 && share <= 1)) table.refuse(node, "window", "is a share of the area, above 0 and up to 1");
  if (!figure.fits.empty() && figure.fits.size() != figure.curves.size()) table.refuse(node, "fits", "must be as many as `curves`");
}

std::string cell_of(const Node& node) { return node.kind == Kind::text ? node.text : study::toml_literal(node); }

void read_where(Table& table, Where& read) {
  const Entry* where = table.take("where");
  if (!where) return;
  if (where->value.kind != Kind::table) return table.refuse(where->value, "where", "is a table of keys and values");
  for (const Entry& entry : where->value.entries) {
    std::vector<std::string> values;
    if (entry.value.kind == Kind::array)
      for (const Node& item : entry.value.items) values.push_back(cell_of(item));
    else
      values.push_back(cell_of(entry.value));
    read.emplace_back(entry.key, std::move(values));
  }
}

/// Reads every table of the list at `key`.
template <class T, class Read>
void read_each(Table& table, const char* key, const std::string& file, std::vector<Problem>& problems, std::vector<T>& values, Read read) {
  const Entry* list = table.take(key);
  if (!list) return;
  for (const Node& item : list->value.items) {
    Table inner(item, file, problems);
    read(inner, item, values.emplace_back());
    inner.refuse_unknown();
  }
}

Figure read_figure(const Node& node, const std::string& file, std::vector<Problem>& problems) {
  Figure figure;
  Table table(node, file, problems);
  table.text("id", figure.id, true);
  table.text("title", figure.title, true);
  table.text("source", figure.source);
  table.text("caption", figure.caption);
  table.text("x", figure.x);
  table.texts("y", figure.y);
  table.texts("curves", figure.curves);
  table.text("curve_x", figure.curve_x);
  table.texts("fits", figure.fits);
  table.flag("share_above", figure.share_above);
  table.flag("counts", figure.counts);
  table.number("sectors", figure.sectors);
  table.number("window", figure.window);
  read_spread(table, node, figure);
  table.text("stage", figure.stage);
  read_kind(table, node, figure);
  table.texts("names", figure.names);
  table.text("by", figure.by);
  table.text("by_label", figure.by_label);
  table.text("by_empty", figure.by_empty);
  table.flag("lines", figure.lines);
  for (auto [axis, prefix] : {std::pair(&figure.x_axis, std::string("x_")), {&figure.y_axis, "y_"}}) {
    table.text((prefix + "label").c_str(), axis->label);
    table.flag((prefix + "log").c_str(), axis->logarithmic);
    table.number((prefix + "low").c_str(), axis->low);
    table.number((prefix + "high").c_str(), axis->high);
  }
  read_where(table, figure.where);
  read_each(table, "references", file, problems, figure.references, [](Table& inner, const Node&, FigureReference& reference) {
    inner.number("x", reference.x);
    inner.number("y", reference.y);
    inner.number("slope", reference.slope);
    inner.text("label", reference.label);
  });
  read_each(table, "source_points", file, problems, figure.source_points, [](Table& inner, const Node& item, SourcePoints& points) {
    inner.text("name", points.name, true);
    inner.number("part", points.part);
    inner.flag("film", points.film);
    inner.numbers("x", points.x);
    inner.numbers("y", points.y);
    if (points.x.size() != points.y.size()) inner.refuse(item, "y", "must be as many as `x`");
  });
  read_each(table, "beside", file, problems, figure.beside, [](Table& inner, const Node&, BesideCurve& curve) {
    inner.text("name", curve.name, true);
    inner.text("x", curve.x, true);
    inner.text("y", curve.y, true);
    read_where(inner, curve.where);
  });
  table.refuse_unknown();
  check_figure(table, node, figure);
  return figure;
}

}  // namespace

const char* word_for(FigureKind kind) { return words[static_cast<std::size_t>(kind)]; }

bool shows_a_run(FigureKind kind) { return kind >= FigureKind::grains; }

std::vector<Figure> read_figures(const std::string& text, const std::string& file) {
  const Node root = study::read_document(text, file);
  std::vector<Problem> problems;
  std::vector<Figure> figures;
  for (const Entry& entry : root.entries) {
    if (entry.key != "figures" || entry.value.kind != Kind::array) {
      problems.push_back({file, entry.place.line, entry.place.column, fmt::format("`{}` is unknown; figures are written as [[figures]]", entry.key)});
      continue;
    }
    for (const Node& node : entry.value.items) figures.push_back(read_figure(node, file, problems));
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return figures;
}

}  // namespace arenite::report
