#include "report/study/study_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "report/drawn.hpp"
#include "report/figures/figure_document.hpp"
#include "report/page_template.hpp"
#include "report/study/default_figures.hpp"
#include "report/study/study_drawing.hpp"
#include "report/study/study_figures.hpp"

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

/// NaN as what is not known.
Numbers known_list(const std::vector<double>& values) {
  return mapped(values, [](double v) { return std::isfinite(v) ? Numbers(v) : Numbers(); });
}

/// The source's figure, what is said of ours and of its scatter, and how wide a sample is.
std::string caption_of(const Figure& figure, const std::string& spread, const Numbers& shown) {
  std::string all;
  const auto add = [&](std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    if (!sentence.empty()) all += (all.empty() ? "" : " ") + sentence + ".";
  };
  add(figure.source);
  add(figure.caption);
  add(spread);
  if (shown.contains("sample") && shown["sample"].contains("size"))
    add(fmt::format("{:.3g} mm across", shown["sample"]["size"][0].get<double>()));
  return all;
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
  about["table"] = runs_table(page.table, figures::headlines_of(page.tests.kind), page.link);
  about["figures"] = Numbers::list();
  for (const auto& [head, drawing] : page.tests.laws) {
    about["figures"].push_back(figures::numbers_of(head));
    about["figures"].back()["drawing"] = figures::numbers_of(drawing, known_list);
  }
  campaign::CollectedTable table = page.table;
  std::erase_if(table.rows, [](const auto& row) { return row.status != "done"; });
  for (const Figure& figure : page.figures) {
    const auto curves = curves_of(figure, table, page.numbers);
    Numbers shown{{"id", figure.id}, {"title", figure.title}};
    if (const auto drawing = drawing_of(figure, curves, page.table);
        !drawing.panels.empty() || drawing.outlines || drawing.cells)
      shown["drawing"] = figures::numbers_of(drawing, known_list);
    if (const auto names = absent(figure, curves); !names.empty())
      shown["missing"] = fmt::format("No finished run has its numbers yet: {}.", names);
    if (shows_a_run(figure.kind)) add_drawing(shown, figure, run_of(figure, table), page);
    shown["caption"] = caption_of(figure, spread_text(figure, curves), shown);
    about["figures"].push_back(std::move(shown));
  }
  return about;
}

fs::path numbers_beside(fs::path page) { return page.replace_extension(".hdf5"); }

}  // namespace

std::string spread_text(const Figure& figure, const std::vector<FigureCurve>& curves) {
  const Samples ours = samples_of(curves, false), film = samples_of(curves, true);
  const std::size_t most = std::max(ours.most, film.most);
  if (most == 0 || figure.kind == FigureKind::map) return "";
  if (most == 1) {
    const bool has_bars = std::ranges::any_of(curves, [](const FigureCurve& curve) {
      return curve.most == 1 && std::ranges::any_of(curve.points.error, [](double e) { return e > 0; });
    });
    return has_bars ? "One sample; bars: the standard error that it tells of itself" : "One sample";
  }
  std::string text = fmt::format("{}: {} over {}", marks_of(figure),
                                 figure.spread == Spread::deviation ? "standard deviation" : "standard error",
                                 number_of(ours.most > 0 ? ours : film));
  if (ours.most > 0 && film.most > 0 && (film.fewest != ours.fewest || film.most != ours.most))
    text += fmt::format("; of the film: {}", number_of(film));
  return text;
}

std::string html_of(Numbers document) {
  document["notation"] = figures::notation;
  document["drawn"] = drawn();
  std::string json = to_json(document, -1);
  for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.replace(at, 2, "<\\/");
  return filled(study_template(),
                {{"__TITLE__", html_text(document["title"].get<std::string>())}, {"__FIGURES__", json}});
}

void write_study_page(const fs::path& path, const StudyPage& page) {
  const Numbers document = document_of(page);
  io::write_numbers_file(numbers_beside(path), {{"title", document["title"]}, {"figures", document["figures"]}});
  io::write_atomically(path, html_of(document));
}

Numbers figures_on(const fs::path& page) { return io::read_numbers_file(numbers_beside(page)); }

}  // namespace arenite::report
