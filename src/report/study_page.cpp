#include "report/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.hpp"
#include "io/atomic_file.hpp"
#include "report/page_template.hpp"
#include "report/template_marks.hpp"

namespace arenite::report {
namespace {

using Json = nlohmann::ordered_json;

struct Reach {
  double low = statistics::unknown, high = statistics::unknown;
  void add(double value) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
};

bool can_show(const FigureAxis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

/// How far the axis goes: as it is asked to, otherwise past all values by a twentieth.
Json domain(const FigureAxis& axis, const Reach& reach) {
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

Json axis_json(const FigureAxis& axis, const std::string& name, const Reach& reach) {
  return {{"label", axis.label.empty() ? name : axis.label}, {"log", axis.logarithmic}, {"domain", domain(axis, reach)}};
}

Json figure_json(const Figure& figure, const std::vector<FigureCurve>& curves) {
  Reach x, y;
  Json series = Json::array();
  for (const auto& curve : curves) {
    Json points = Json::array();
    for (std::size_t k = 0; k < curve.points.x.size(); ++k) {
      const double at = curve.points.x[k], value = curve.points.y[k], error = curve.points.error[k];
      if (!can_show(figure.x_axis, at) || !can_show(figure.y_axis, value)) continue;
      const bool outside = at < figure.x_axis.low.value_or(at) || at > figure.x_axis.high.value_or(at);
      if (outside) continue;
      x.add(at);
      y.add(value);
      if (std::isfinite(error)) y.add(value + error);
      if (std::isfinite(error) && can_show(figure.y_axis, value - error)) y.add(std::max(value - error, figure.y_axis.logarithmic ? 0.3 * value : value - error));
      points.push_back({at, value, std::isfinite(error) ? error : 0.0});
    }
    if (!points.empty()) series.push_back({{"name", curve.name}, {"group", curve.group}, {"part", curve.part}, {"points", points}});
  }
  Json references = Json::array();
  for (const auto& r : figure.references) {
    Json one{{"label", r.label}};
    if (r.x) one["x"] = *r.x, x.add(*r.x);
    if (r.y) one["y"] = *r.y, y.add(*r.y);
    references.push_back(one);
  }
  const std::string name = !figure.curves.empty() ? figure.curves.front() : figure.y.empty() ? "" : figure.y.front();
  return {{"id", figure.id}, {"kind", word_for(figure.kind)}, {"title", figure.title}, {"source", figure.source}, {"caption", figure.caption}, {"lines", figure.lines},
          {"density", !figure.curves.empty() && figure.curve_x.empty()},
          {"ordered", !figure.by.empty()}, {"x", axis_json(figure.x_axis, figure.x, x)}, {"y", axis_json(figure.y_axis, name, y)},
          {"series", series}, {"references", references}};
}

}  // namespace

std::string study_page(const StudyPage& page) {
  Json about{{"title", page.title}};
  const auto done = static_cast<std::size_t>(std::count_if(page.table.rows.begin(), page.table.rows.end(), [](const auto& row) { return row.status == "done"; }));
  about["runs"] = fmt::format("{} of {} runs; bars are standard errors over samples", done, page.table.rows.size());
  about["made"] = fmt::format("Arenite {}. Dashed lines and crosses are what the text of the source says.", version);
  about["figures"] = Json::array();
  study::CollectedTable table = page.table;
  std::erase_if(table.rows, [](const auto& row) { return row.status != "done"; });
  for (const Figure& figure : page.figures) {
    about["figures"].push_back(figure_json(figure, curves_of(figure, table, page.numbers)));
    const bool forces = figure.kind == FigureKind::forces;
    if (!forces && figure.kind != FigureKind::stresses) continue;
    if (const std::string run = run_of(figure, table); !run.empty() && page.drawing) about["figures"].back()["sample"] = Json::parse(page.drawing(run, forces));
  }
  std::string json = about.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.replace(at, 2, "<\\/");
  std::string text(study_template());
  replace_once(text, "__TITLE__", html_text(page.title));
  replace_once(text, "__FIGURES__", json);
  return text;
}

void write_study_page(const std::filesystem::path& path, const StudyPage& page) { io::write_atomically(path, study_page(page)); }

}  // namespace arenite::report
