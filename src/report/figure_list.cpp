#include "report/figure_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/error.hpp"
#include "study/recipe_document.hpp"

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

/// What the kind of figure needs.
void check_figure(Table& table, const Node& node, const Figure& figure) {
  const bool points = !figure.x.empty() && !figure.y.empty();
  if (figure.kind == FigureKind::plot && figure.curves.empty() && !points) table.refuse(node, "x", "and `y` say what is drawn, or `curves`");
  if (figure.kind == FigureKind::rose && figure.curves.empty()) table.refuse(node, "curves", "say what a rose shows");
  if (figure.kind == FigureKind::map && (!points || figure.by.empty() || figure.y.size() != 1)) table.refuse(node, "x", ", `by` and one `y` say what a map shows");
  if (const std::size_t n = figure.curves.empty() ? figure.y.size() : figure.curves.size(); !figure.names.empty() && figure.names.size() != n)
    table.refuse(node, "names", fmt::format("must be as many as what is drawn: {}", n));
  if (!figure.fits.empty() && figure.fits.size() != figure.curves.size()) table.refuse(node, "fits", "must be as many as `curves`");
}

std::string cell_of(const Node& node) { return node.kind == Kind::text ? node.text : study::toml_literal(node); }

void read_where(Table& table, Figure& figure) {
  const Entry* where = table.take("where");
  if (!where) return;
  if (where->value.kind != Kind::table) return table.refuse(where->value, "where", "is a table of keys and values");
  for (const Entry& entry : where->value.entries) {
    std::vector<std::string> values;
    if (entry.value.kind == Kind::array)
      for (const Node& item : entry.value.items) values.push_back(cell_of(item));
    else
      values.push_back(cell_of(entry.value));
    figure.where.emplace_back(entry.key, std::move(values));
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
  read_where(table, figure);
  if (const Entry* list = table.take("references"))
    for (const Node& item : list->value.items) {
      FigureReference reference;
      Table inner(item, file, problems);
      inner.number("x", reference.x);
      inner.number("y", reference.y);
      inner.number("slope", reference.slope);
      inner.text("label", reference.label);
      inner.refuse_unknown();
      figure.references.push_back(std::move(reference));
    }
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
