#include "report/spread_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace arenite::report {
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
  return samples.fewest == samples.most ? fmt::format("{} samples", samples.most) : fmt::format("{} to {} samples", samples.fewest, samples.most);
}

const char* marks_of(const Figure& figure) {
  if (figure.kind == FigureKind::rose) return "Ticks";
  return figure.curves.empty() || !figure.curve_x.empty() || !figure.lines ? "Bars" : "Bands";
}

}  // namespace

std::string spread_text(const Figure& figure, const std::vector<FigureCurve>& curves) {
  const Samples ours = samples_of(curves, false), film = samples_of(curves, true);
  const std::size_t most = std::max(ours.most, film.most);
  if (most == 0 || figure.kind == FigureKind::map) return "";
  if (most == 1) return "One sample";
  std::string text = fmt::format("{}: {} over {}", marks_of(figure), figure.spread == Spread::deviation ? "standard deviation" : "standard error", number_of(ours.most > 0 ? ours : film));
  if (ours.most > 0 && film.most > 0 && (film.fewest != ours.fewest || film.most != ours.most)) text += fmt::format("; of the film: {}", number_of(film));
  return text;
}

}  // namespace arenite::report
