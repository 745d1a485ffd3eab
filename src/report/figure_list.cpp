#include "report/figure_list.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/text.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"

namespace arenite::report {
namespace {

using recipe::Entry;
using recipe::Node;
using Kind = Node::Kind;

bool get(const Node& node, double& value) {
  if (node.kind != Kind::integer && node.kind != Kind::real) return false;
  value = node.kind == Kind::integer ? static_cast<double>(node.integer) : node.real;
  return true;
}
bool get(const Node& node, std::optional<double>& value) { return get(node, value.emplace()); }
bool get(const Node& node, std::string& value) {
  value = node.text;
  return node.kind == Kind::text;
}
bool get(const Node& node, bool& value) {
  value = node.flag;
  return node.kind == Kind::flag;
}

template <class T> constexpr const char* wanted = "is a number";
template <> constexpr const char* wanted<std::string> = "is a text in quotes";
template <> constexpr const char* wanted<bool> = "is true or false";
template <> constexpr const char* wanted<std::vector<std::string>> = "is a list of texts";
template <> constexpr const char* wanted<std::vector<double>> = "is a list of numbers";

/// Reads the keys of one table; what is left over is unknown.
class Table {
 public:
  Table(const Node& node, const std::string& file, std::vector<Problem>& problems)
      : node_(node),
        file_(file),
        problems_(problems) {}

  template <class T> void read(const std::string& key, T& value, bool needed = false) {
    const Entry* entry = take(key);
    if (!entry && needed) refuse(node_, key, "is missing");
    if (entry && !get(entry->value, value)) refuse(entry->value, key, wanted<T>);
  }
  template <class T> void read(const std::string& key, std::vector<T>& values) {
    const Entry* entry = take(key);
    if (!entry) return;
    if (entry->value.kind != Kind::array) return refuse(entry->value, key, wanted<std::vector<T>>);
    for (const Node& item : entry->value.items)
      if (T value; get(item, value)) values.push_back(std::move(value));
      else refuse(item, key, wanted<std::vector<T>>);
  }
  const Entry* take(const std::string& key) {
    known_.insert(key);
    return node_.find(key);
  }
  void refuse_unknown() {
    for (const Entry& entry : node_.entries)
      if (!known_.contains(entry.key))
        problems_.push_back(
            {file_, entry.place.line, entry.place.column, fmt::format("`{}` is not a key of a figure", entry.key)});
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

constexpr std::array words = {"plot",     "rose", "map",    "grains", "forces",
                              "stresses", "film", "phases", "zoom",   "cracks"};
constexpr std::array spreads = {"error", "deviation"};

/// One of the words that the values of an enumeration have in their order.
template <class Choice>
void read_choice(Table& table, const Node& node, const char* key, const auto& among, Choice& choice) {
  std::string word = among[static_cast<std::size_t>(choice)];
  table.read(key, word);
  const auto at = std::find(among.begin(), among.end(), word);
  if (at == among.end()) return table.refuse(node, key, fmt::format("is one of {}", list_of(among)));
  choice = static_cast<Choice>(at - among.begin());
}

/// What the kind of figure needs.
void check_figure(Table& table, const Node& node, const Figure& figure) {
  const bool points = !figure.x.empty() && !figure.y.empty();
  if (figure.kind == FigureKind::plot && figure.curves.empty() && !points)
    table.refuse(node, "x", "and `y`, or `curves`, are needed");
  if (figure.kind == FigureKind::rose && figure.curves.empty()) table.refuse(node, "curves", "are needed for a rose");
  if (figure.kind == FigureKind::map && (!points || figure.by.empty() || figure.y.size() != 1))
    table.refuse(node, "x", ", `by` and one `y` are needed for a map");
  if (const std::size_t n = figure.curves.empty() ? figure.y.size() : figure.curves.size();
      !figure.names.empty() && figure.names.size() != n)
    table.refuse(node, "names", fmt::format("must be as many as the curves drawn: {}", n));
  if (const double n = figure.sectors.value_or(18); !(n >= 2 && n <= 360 && n == std::floor(n)))
    table.refuse(node, "sectors", "is a whole number, 2 to 360");
  if (const double share = figure.window.value_or(1); !(share > 0 && share <= 1))
    table.refuse(node, "window", "is a fraction of the area, above 0 and up to 1");
  if (!figure.fits.empty() && figure.fits.size() != figure.curves.size())
    table.refuse(node, "fits", "must be as many as `curves`");
}

std::string cell_of(const Node& node) { return node.kind == Kind::text ? node.text : recipe::toml_literal(node); }

void read_where(Table& table, Where& read) {
  const Entry* where = table.take("where");
  if (!where) return;
  if (where->value.kind != Kind::table) return table.refuse(where->value, "where", "is a table of keys and values");
  for (const Entry& entry : where->value.entries) {
    const bool is_list = entry.value.kind == Kind::array;
    read.emplace_back(entry.key, is_list ? mapped(entry.value.items, cell_of) : std::vector{cell_of(entry.value)});
  }
}

/// Reads every table of the list at `key`.
template <class T, class Read>
void read_each(Table& table, const char* key, const std::string& file, std::vector<Problem>& problems,
               std::vector<T>& values, Read read) {
  const Entry* list = table.take(key);
  if (!list) return;
  for (const Node& item : list->value.items) {
    Table inner(item, file, problems);
    read(inner, item, values.emplace_back());
    inner.refuse_unknown();
  }
}

/// What numbers were called in version 0.1, and are called now.
constexpr std::pair<std::string_view, std::string_view> former_names[] = {
    {"twin", "simulation"},
    {"raster", "grid"},
    {"even_pdf", "histogram"},
    {"own_even_pdf", "own_histogram"},
    {"directions", "contact_orientations"},
    {"joints", "necks"},
    {"lost_joints", "lost_necks"},
    {"thinnest_joint_nodes", "thinnest_neck_nodes"},
    {"identity_defect", "reaction_balance_error"},
    {"energy_defect", "energy_balance_error"},
    {"share_above_mean", "fraction_above_mean"},
    {"share_above_own_mean", "fraction_above_own_mean"},
    {"share_above_sample_mean", "fraction_above_sample_mean"},
    {"share_above_mean_of_all", "fraction_above_mean_of_all"}};

/// Numbers under their names of now, each step of a dotted path.
void rename_former(std::vector<std::string*> paths, std::vector<std::string>& notices) {
  for (std::string* path : paths)
    for (std::size_t begin = 0; begin < path->size(); begin = std::min(path->find('.', begin), path->size() - 1) + 1) {
      const std::string step = path->substr(begin, path->find('.', begin) - begin);
      const auto* const known = std::ranges::find(former_names, step, [](const auto& names) { return names.first; });
      if (known == std::end(former_names)) continue;
      recipe::note_former_name(notices, step, known->second);
      path->replace(begin, step.size(), known->second);
    }
}

Figure read_figure(const Node& node, const std::string& file, std::vector<Problem>& problems,
                   std::vector<std::string>& notices) {
  Figure figure;
  Table table(node, file, problems);
  table.read("id", figure.id, true);
  table.read("title", figure.title, true);
  table.read("source", figure.source);
  table.read("caption", figure.caption);
  table.read("x", figure.x);
  table.read("y", figure.y);
  table.read("curves", figure.curves);
  table.read("curve_x", figure.curve_x);
  table.read("fits", figure.fits);
  for (const char* key : {"survival", "share_above"}) table.read(key, figure.survival);
  if (node.find("share_above")) recipe::note_former_name(notices, "share_above", "survival");
  table.read("counts", figure.counts);
  table.read("sectors", figure.sectors);
  table.read("window", figure.window);
  read_choice(table, node, "spread", spreads, figure.spread);
  table.read("stage", figure.stage);
  read_choice(table, node, "kind", words, figure.kind);
  table.read("names", figure.names);
  table.read("by", figure.by);
  table.read("by_label", figure.by_label);
  table.read("by_empty", figure.by_empty);
  table.read("lines", figure.lines);
  for (auto [axis, prefix] : {std::pair(&figure.x_axis, std::string("x_")), {&figure.y_axis, "y_"}}) {
    table.read(prefix + "label", axis->label);
    table.read(prefix + "log", axis->logarithmic);
    table.read(prefix + "low", axis->low);
    table.read(prefix + "high", axis->high);
  }
  read_where(table, figure.where);
  read_each(table, "references", file, problems, figure.references,
            [](Table& inner, const Node&, FigureReference& reference) {
              inner.read("x", reference.x);
              inner.read("y", reference.y);
              inner.read("slope", reference.slope);
              inner.read("label", reference.label);
            });
  read_each(table, "source_points", file, problems, figure.source_points,
            [](Table& inner, const Node& item, SourcePoints& points) {
              inner.read("name", points.name, true);
              inner.read("part", points.part);
              inner.read("film", points.film);
              inner.read("x", points.x);
              inner.read("y", points.y);
              if (points.x.size() != points.y.size()) inner.refuse(item, "y", "must be as many as `x`");
            });
  read_each(table, "beside", file, problems, figure.beside, [](Table& inner, const Node&, BesideCurve& curve) {
    inner.read("name", curve.name, true);
    inner.read("x", curve.x, true);
    inner.read("y", curve.y, true);
    read_where(inner, curve.where);
  });
  std::vector<std::string*> paths{&figure.x, &figure.curve_x};
  for (auto* list : {&figure.y, &figure.curves, &figure.fits})
    for (std::string& path : *list) paths.push_back(&path);
  for (BesideCurve& curve : figure.beside) paths.insert(paths.end(), {&curve.x, &curve.y});
  rename_former(paths, notices);
  table.refuse_unknown();
  check_figure(table, node, figure);
  return figure;
}

}  // namespace

const char* word_for(FigureKind kind) { return words[static_cast<std::size_t>(kind)]; }

std::vector<Figure> read_figures(const std::string& text, const std::string& file, std::vector<std::string>* notices) {
  const Node root = recipe::read_document(text, file);
  std::vector<Problem> problems;
  std::vector<std::string> former;
  std::vector<Figure> figures;
  for (const Entry& entry : root.entries) {
    if (entry.key != "figures" || entry.value.kind != Kind::array) {
      problems.push_back({file, entry.place.line, entry.place.column,
                          fmt::format("`{}` is unknown; figures are written as [[figures]]", entry.key)});
      continue;
    }
    for (const Node& node : entry.value.items) figures.push_back(read_figure(node, file, problems, former));
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  if (notices) *notices = std::move(former);
  return figures;
}

}  // namespace arenite::report
