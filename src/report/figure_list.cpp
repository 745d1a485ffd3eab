#include "report/figure_list.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "recipe/declared.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"

namespace arenite::report {
namespace {

using Visitor = ParameterVisitor;

/// In the order of FigureKind.
const std::vector<Word>& kinds() {
  static const std::vector<Word> words = {
      {"plot", "points and lines"},
      {"rose",
       "`curves` are counts in angular sectors, drawn relative to the isotropic value, or with `counts = true` as the "
       "mean numbers of contacts of a sample"},
      {"map", "a single `y` as a colour over `x` and `by`"},
      {"grains", "the grains of a run by material, in its last state or in that of `stage`"},
      {"forces", "its grains with their normal forces"},
      {"stresses", "its grains coloured by their stress over the mean"},
      {"film", "the stresses of its grains as measured on a film"},
      {"phases", "the nodes of its cemented sample"},
      {"zoom",
       "the vertical stress in and around the large grain nearest to the middle, in its first load or that of `stage`"},
      {"cracks", "its phases and the bonds broken in its first load, or in that of `stage`"}};
  return words;
}

struct AxisKeys {
  Key label, log, low, high;
};
constexpr AxisKeys x_keys{
    {"x_label", "Label of the x axis; unless given, the declared meaning of the number or key, with its unit."},
    {"x_log", "A logarithmic x axis."},
    {"x_low", "Where the x axis begins; unless given, where the points do."},
    {"x_high", "Where it ends."}};
constexpr AxisKeys y_keys{{"y_label", "The same of the y axis."},
                          {"y_log", "A logarithmic y axis."},
                          {"y_low", "Where the y axis begins; unless given, where the points do."},
                          {"y_high", "Where it ends."}};

void declare_axis(Visitor& v, const AxisKeys& keys, FigureAxis& axis) {
  v.text(keys.label, axis.label);
  v.flag(keys.log, axis.logarithmic);
  v.number(keys.low, axis.low, "", range::any);
  v.number(keys.high, axis.high, "", range::any);
}

constexpr Key where_key{"where", "Only runs with these values of swept keys count; a list gives several values."};

void declare_reference(Visitor& v, FigureReference& reference) {
  v.number({"x", "An abscissa; with `y`, a point."}, reference.x, "", range::any);
  v.number({"y", "A level."}, reference.y, "", range::any);
  v.number({"slope", "A line through the origin."}, reference.slope, "", range::any);
  v.text({"label", "What the source says there."}, reference.label);
}

void declare_source_points(Visitor& v, SourcePoints& points) {
  v.text({"name", "What the key of the figure calls them.", true}, points.name);
  v.integer({"part", "Which of `y` or `curves` they belong to, from 0."}, points.part, {0, 1000});
  v.flag({"film", "They are measured, by a source that also has simulated ones."}, points.film);
  v.numbers({"x", "Abscissae."}, points.x, "", range::any);
  v.numbers({"y", "Ordinates."}, points.y, "", range::any);
  v.require(points.x.size() == points.y.size(), {"y"}, "must be as many as x");
}

void declare_beside(Visitor& v, BesideCurve& curve) {
  v.text({"name", "What the key of the figure calls it.", true}, curve.name);
  v.text({"x", "As of the figure.", true}, curve.x);
  v.text({"y", "As of the figure.", true}, curve.y);
  v.wanted(where_key, curve.where);
}

void declare_quantities(Visitor& v, Figure& figure) {
  v.text({"x",
          "A swept key or a number of the runs, \"1/NAME\", the quotient of two numbers, or a literal number. A point "
          "is the mean over runs that differ only in their seed, its bar the standard error over them."},
         figure.x);
  v.texts({"y", "Numbers of the runs."}, figure.y);
  v.texts({"curves",
           "Instead of `x` and `y`: probability densities of the runs' numbers, averaged over runs (\"pores.pdf\", "
           "\"stress.sigma_yy.sets.large.histogram\"); of packings also those of `arenite measure --json --curves` "
           "(\"sigma_norm.by_material.POM.pdf_over_all\"), for which the last states are measured again."},
          figure.curves);
  v.text({"curve_x", "A list that the lists in `curves` are drawn against (\"rev.area_share\" for \"rev.mean\")."},
         figure.curve_x);
  v.texts(
      {"fits",
       "One for each of `curves`, \"\" for none: exponential tails in the runs' numbers "
       "(\"stress.sigma_yy.sets.large.tail\"), drawn over the fitted range of the density; of a set with `beta_line` "
       "(\"sigma_norm\") the regression line of ln P, drawn over the survival function."},
      figure.fits);
  v.flag({"survival",
          "Instead of densities, the survival function (the fraction above x) of each sample, averaged over samples.",
          false, "share_above"},
         figure.survival);
  v.flag({"counts", "Of a rose: mean numbers of contacts of a sample instead of their share."}, figure.counts);
  v.integer({"sectors",
             "Of a rose: the last states are measured again with that many sectors; stored results of a film are "
             "redistributed among them."},
            figure.sectors, {2, 360});
  v.number({"window",
            "For `curves = [\"window.solid_fraction\"]` against `curve_x = \"window.place\"`: the solid fraction of "
            "windows with this fraction of the area of the box at 50 random positions, the same in every sample."},
           figure.window, "", range::above(0, 1));
}

/// What the kind of figure needs.
void require_what_is_drawn(Visitor& v, const Figure& figure) {
  const bool points = !figure.x.empty() && !figure.y.empty();
  v.require(figure.kind != FigureKind::plot || !figure.curves.empty() || points, {"x"},
            "x and y, or curves, are needed");
  v.require(figure.kind != FigureKind::rose || !figure.curves.empty(), {"curves"}, "curves are needed for a rose");
  v.require(figure.kind != FigureKind::map || (points && !figure.by.empty() && figure.y.size() == 1), {"x"},
            "x, by and one y are needed for a map");
  const std::size_t drawn = figure.curves.empty() ? figure.y.size() : figure.curves.size();
  v.require(figure.names.empty() || figure.names.size() == drawn, {"names"},
            "must be as many as what is drawn, y or curves");
  v.require(figure.fits.empty() || figure.fits.size() == figure.curves.size(), {"fits"}, "must be as many as curves");
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

struct FigureList {
  std::vector<Figure> figures;
};
void declare(Visitor& v, FigureList& list) {
  v.list<Figure>({"figures", "A figure of a study's page."}, list.figures,
                 [](Visitor& inner, Figure& figure) { report::declare(inner, figure); });
}

void rename_former_numbers(Figure& figure, std::vector<std::string>& notices) {
  std::vector<std::string*> paths{&figure.x, &figure.curve_x};
  for (auto* list : {&figure.y, &figure.curves, &figure.fits})
    for (std::string& path : *list) paths.push_back(&path);
  for (BesideCurve& curve : figure.beside) paths.insert(paths.end(), {&curve.x, &curve.y});
  rename_former(paths, notices);
}

}  // namespace

const char* word_for(FigureKind kind) { return kinds()[static_cast<std::size_t>(kind)].word.data(); }

void declare(Visitor& v, Figure& figure) {
  v.text({"id", "Its name.", true}, figure.id);
  v.text({"title", "What stands above it.", true}, figure.title);
  v.text({"source", "The figure of the source that it repeats."}, figure.source);
  v.text({"caption", "What stands below it."}, figure.caption);
  v.choice({"kind", "How it is drawn. Pictures show the first run that `where` selects."}, figure.kind, kinds());
  declare_quantities(v, figure);
  v.texts({"names", "What the key of the figure calls several `y` or `curves`."}, figure.names);
  v.text({"by", "A swept key: a curve for each of its values."}, figure.by);
  v.text({"by_label", "What the key of the figure calls it; unless given, its symbol."}, figure.by_label);
  v.text({"by_empty", "What it calls runs without that value."}, figure.by_empty);
  v.wanted(where_key, figure.where);
  v.text({"stage", "Whose last state is shown (\"packing\": before any loading); unless given, the last one's."},
         figure.stage);
  v.choice({"spread",
            "What bars of points, bands of densities drawn as lines and ticks of roses are. The caption states it, and "
            "over how many samples."},
           figure.spread, {{"error", "standard errors over samples"}, {"deviation", "standard deviations"}});
  v.flag({"lines", "Points are joined; false: they are not, and densities are points."}, figure.lines);
  declare_axis(v, x_keys, figure.x_axis);
  declare_axis(v, y_keys, figure.y_axis);
  v.list<BesideCurve>({"beside", "Curves of other runs or numbers."}, figure.beside, declare_beside);
  v.list<SourcePoints>({"source_points", "Values from the source's tables or text, drawn as crosses."},
                       figure.source_points, declare_source_points);
  v.list<FigureReference>({"references", "Statements of the source's text."}, figure.references, declare_reference);
  require_what_is_drawn(v, figure);
}

std::string figure_key_reference() {
  return "# Figures of a study\n\n"
         "The keys of figures.toml, which declares the figures of a study's page ([studies.md](studies.md)). It is "
         "written like every\n"
         "recipe ([recipe.md](recipe.md)), and every problem is reported at once. This page is generated: `arenite man "
         "--figure-keys`.\n\n" +
         recipe::write_key_tables(recipe::all_keys<FigureList>());
}

std::vector<Figure> read_figures(const std::string& text, const std::string& file, std::vector<std::string>* notices) {
  recipe::Node root = recipe::read_document(text, file);
  recipe::Reading reading = recipe::of_text(file);
  recipe::rename_former_keys(root, recipe::all_keys<FigureList>(), reading.notices);
  FigureList list;
  recipe::read_declared(root, reading, [&](Visitor& visitor) { declare(visitor, list); });
  for (Figure& figure : list.figures) rename_former_numbers(figure, reading.notices);
  if (notices) *notices = std::move(reading.notices);
  return list.figures;
}

}  // namespace arenite::report
