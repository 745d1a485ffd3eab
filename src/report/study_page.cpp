#include "report/study_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "report/page_template.hpp"

namespace arenite::report {

namespace fs = std::filesystem;

namespace {

struct Samples {
  std::size_t fewest = 0, most = 0;
};

/// Of a film's curves or of the others.
Samples samples_of(const std::vector<FigureCurve>& curves, bool film) {
  Samples all;
  for (const FigureCurve& curve : curves) {
    if (curve.most == 0 || curve.film != film) continue;
    all.fewest = all.fewest == 0 ? curve.fewest : std::min(all.fewest, curve.fewest);
    all.most = std::max(all.most, curve.most);
  }
  return all;
}

std::string number_of(const Samples& samples) {
  if (samples.most == 1) return "one sample";
  return samples.fewest == samples.most ? fmt::format("{} samples", samples.most)
                                        : fmt::format("{} to {} samples", samples.fewest, samples.most);
}

const char* marks_of(const Figure& figure) {
  if (figure.kind == FigureKind::rose) return "Ticks";
  return figure.curves.empty() || !figure.curve_x.empty() || !figure.lines ? "Bars" : "Bands";
}

struct Reach {
  double low = statistics::unknown, high = statistics::unknown;
  void add(double value) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
};

bool can_show(const FigureAxis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

/// How far the axis goes: as it is asked to, otherwise past all values by a twentieth.
Numbers domain(const FigureAxis& axis, const Reach& reach) {
  double low = reach.low, high = reach.high;
  if (axis.logarithmic) {
    const double more = std::pow(high / low, 0.04);
    low /= more;
    high *= more;
  } else {
    const double more = 0.05 * (high > low ? high - low : std::abs(high) + 1e-12);
    low -= more;
    high += more;
  }
  return {axis.low.value_or(low), axis.high.value_or(high)};
}

Numbers axis_json(const FigureAxis& axis, const std::string& name, const Reach& reach,
                  const campaign::CollectedTable& table) {
  return {{"label", axis.label.empty() ? label_of(table, name) : axis.label},
          {"log", axis.logarithmic},
          {"domain", domain(axis, reach)}};
}

bool within(const FigureAxis& axis, double value) {
  return value >= axis.low.value_or(value) && value <= axis.high.value_or(value);
}

Numbers figure_json(const Figure& figure, const std::vector<FigureCurve>& curves,
                    const campaign::CollectedTable& table) {
  Reach x, y;
  Numbers series = Numbers::list();
  const bool density = !figure.curves.empty() && figure.curve_x.empty();
  for (const auto& curve : curves) {
    Numbers points = Numbers::list();
    for (std::size_t k = 0; k < curve.points.x.size(); ++k) {
      const double at = curve.points.x[k], value = curve.points.y[k], error = curve.points.error[k];
      if (!can_show(figure.x_axis, at) || !within(figure.x_axis, at)) continue;
      if (!can_show(figure.y_axis, value) || (density && !curve.fit && !within(figure.y_axis, value))) {
        if (density && !points.empty() && points.back()[1].is_known())
          points.push_back({at, nullptr, 0.0});  // the line is broken there
        continue;
      }
      x.add(at);
      y.add(value);
      if (std::isfinite(error)) y.add(value + error);
      if (std::isfinite(error) && can_show(figure.y_axis, value - error))
        y.add(std::max(value - error, figure.y_axis.logarithmic ? 0.3 * value : value - error));
      points.push_back({at, value, std::isfinite(error) ? error : 0.0});
    }
    if (!points.empty() && !points.back()[1].is_known()) points.pop_back();
    if (!points.empty())
      series.push_back({{"name", curve.name},
                        {"group", curve.group},
                        {"part", curve.part},
                        {"film", curve.film},
                        {"fit", curve.fit},
                        {"beside", curve.beside},
                        {"source", curve.source},
                        {"points", points}});
  }
  Numbers references = Numbers::list();
  for (const auto& r : figure.references) {
    Numbers one{{"label", r.label}};
    if (r.x) one["x"] = *r.x, x.add(*r.x);
    if (r.y) one["y"] = *r.y, y.add(*r.y);
    if (r.slope) one["slope"] = *r.slope;
    references.push_back(one);
  }
  const std::string name = !figure.curves.empty() ? figure.curves.front() : figure.y.empty() ? "" : figure.y.front();
  return {{"id", figure.id},
          {"kind", word_for(figure.kind)},
          {"title", figure.title},
          {"source", figure.source},
          {"caption", figure.caption},
          {"spread", spread_text(figure, curves)},
          {"lines", figure.lines},
          {"density", density},
          {"counts", figure.counts},
          {"ordered", !figure.by.empty()},
          {"x", axis_json(figure.x_axis, figure.x, x, table)},
          {"y", axis_json(figure.y_axis, name, y, table)},
          {"series", series},
          {"references", references}};
}

/// Curves that no run has the numbers for, by what the key would call them.
std::string absent(const Figure& figure, const std::vector<FigureCurve>& curves) {
  const auto& wanted = figure.curves.empty() ? figure.y : figure.curves;
  std::string names;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (std::none_of(curves.begin(), curves.end(),
                     [&](const FigureCurve& curve) { return curve.part == k && !curve.beside && !curve.source; }))
      names += (names.empty() ? "" : ", ") +
               (k < figure.names.size() && !figure.names[k].empty() ? figure.names[k] : wanted[k]);
  return names;
}

/// The run that is drawn, or why none is.
void add_drawing(Numbers& shown, const Figure& figure, const std::string& run, const StudyPage& page) {
  if (run.empty()) {
    shown["missing"] = "No run of this kind has finished yet.";
    return;
  }
  try {
    if (page.drawing) shown["sample"] = page.drawing(run, figure);
  } catch (const InputError& error) {
    shown["missing"] = fmt::format("Not drawn: {}.", error.problems().front().message);
  }
}

/// All that the page shows.
Numbers document_of(const StudyPage& page) {
  Numbers about{{"title", page.title}};
  const auto done = std::ranges::count(page.table.rows, "done", &campaign::CollectedTable::Row::status);
  about["runs"] = fmt::format("{} of {} runs; the caption of each figure explains its bars, bands and ticks", done,
                              page.table.rows.size());
  const bool has_source = std::ranges::any_of(page.figures, [](const Figure& f) {
    return !f.source.empty() || !f.references.empty() || !f.source_points.empty();
  });
  about["made"] = fmt::format("Arenite {}.{}", version,
                              has_source ? " Dashed lines and crosses show statements and tables of the source." : "");
  about["table"] = runs_table(page.table, page.link);
  about["figures"] = Numbers::list();
  campaign::CollectedTable table = page.table;
  std::erase_if(table.rows, [](const auto& row) { return row.status != "done"; });
  for (const Figure& figure : page.figures) {
    const auto curves = curves_of(figure, table, page.numbers);
    about["figures"].push_back(figure_json(figure, curves, page.table));
    if (const auto names = absent(figure, curves); !names.empty())
      about["figures"].back()["missing"] = fmt::format("No finished run has its numbers yet: {}.", names);
    if (shows_a_run(figure.kind)) add_drawing(about["figures"].back(), figure, run_of(figure, table), page);
  }
  return about;
}

std::string html_of(const Numbers& document) {
  std::string json = to_json(document, -1);
  for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.replace(at, 2, "<\\/");
  return filled(study_template(),
                {{"__TITLE__", html_text(document["title"].get<std::string>())}, {"__FIGURES__", json}});
}

fs::path numbers_beside(fs::path page) { return page.replace_extension(".hdf5"); }

}  // namespace

std::string spread_text(const Figure& figure, const std::vector<FigureCurve>& curves) {
  const Samples ours = samples_of(curves, false), film = samples_of(curves, true);
  const std::size_t most = std::max(ours.most, film.most);
  if (most == 0 || figure.kind == FigureKind::map) return "";
  if (most == 1) return "One sample";
  std::string text = fmt::format("{}: {} over {}", marks_of(figure),
                                 figure.spread == Spread::deviation ? "standard deviation" : "standard error",
                                 number_of(ours.most > 0 ? ours : film));
  if (ours.most > 0 && film.most > 0 && (film.fewest != ours.fewest || film.most != ours.most))
    text += fmt::format("; of the film: {}", number_of(film));
  return text;
}

void write_study_page(const fs::path& path, const StudyPage& page) {
  const Numbers document = document_of(page);
  io::write_numbers_file(numbers_beside(path), {{"title", document["title"]}, {"figures", document["figures"]}});
  io::write_atomically(path, html_of(document));
}

Numbers figures_on(const fs::path& page) { return io::read_numbers_file(numbers_beside(page)); }

}  // namespace arenite::report
