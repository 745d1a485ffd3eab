#include "validation/report_dots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/page_template.hpp"

namespace arenite::validation {
namespace {

using validation::Outcome;
using validation::Sensitivity;

constexpr double label_width = 250, panel_width = 190, gap = 18, row_height = 17, title_line = 14, edge = 12;
constexpr std::size_t in_a_strip = 3, title_letters = 27;

/// Light first; the second of each pair in the dark.
constexpr const char* style = R"(<style>
.ground{fill:#ffffff}.band{fill:#dcefe0}.frame{fill:none;stroke:#c9c9c9}.grid{stroke:#ececec}
.usual{stroke:#8a8a8a;stroke-dasharray:3 3}
text{font:12px system-ui,sans-serif;fill:#222222}.tick,.note{font-size:11px;fill:#595959}.title{font-weight:600}
.bar{stroke:#444444}.holds{fill:#1b7a3d;stroke:#1b7a3d}.undecided{fill:#ffffff;stroke:#946300;stroke-width:1.6}
.fails{stroke:#b3261e;stroke-width:1.8;fill:none}
@media (prefers-color-scheme:dark){
.ground{fill:#16181c}.band{fill:#1f3a2a}.frame{stroke:#4a4d52}.grid{stroke:#2a2d31}.usual{stroke:#8f949b}
text{fill:#e6e6e6}.tick,.note{fill:#a9adb3}.bar{stroke:#c4c7cc}.holds{fill:#5fcf8a;stroke:#5fcf8a}
.undecided{fill:#16181c;stroke:#e0b050}.fails{stroke:#ff8a80}}
</style>
)";

std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

/// Of one panel: numbers to places.
struct Axis {
  double low = 0, high = 1, left = 0;
  double place(double x) const { return left + panel_width * (std::clamp(x, low, high) - low) / (high - low); }
};

/// All values and the bounds that are wanted, with some room; bars may end outside.
Axis axis_of(const Sensitivity& found, double left) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto hold = [&](double x) {
    if (!std::isfinite(x)) return;
    low = std::min(low, x);
    high = std::max(high, x);
  };
  for (const auto& entry : found.entries) hold(entry.value.value);
  hold(found.range.low);
  hold(found.range.high);
  const double room = high > low ? 0.12 * (high - low) : std::max(0.1 * std::abs(low), 1e-9);
  return {low - room, high + room, left};
}

/// Round numbers, about four.
std::vector<double> ticks(const Axis& axis) {
  const double rough = (axis.high - axis.low) / 3.5, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10);
  std::vector<double> at;
  for (double x = std::ceil(axis.low / step) * step; x <= axis.high; x += step)
    at.push_back(std::abs(x) < 1e-9 * step ? 0 : x);
  return at;
}

std::string text_at(double x, double y, const char* kind, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, kind, anchor,
                     report::html_text(text));
}

std::string line(double x0, double y0, double x1, double y1, const char* kind) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x0, y0, x1, y1,
                     kind);
}

/// A full dot, a hollow one, a cross: not distinguished by colour alone.
std::string mark(double x, double y, Outcome outcome) {
  if (outcome == Outcome::fails)
    return fmt::format("<path d=\"M{:.1f} {:.1f}l7 7m0 -7l-7 7\" class=\"fails\"/>\n", x - 3.5, y - 3.5);
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" class=\"{}\"/>\n", x, y,
                     outcome == Outcome::holds ? "holds" : "undecided");
}

std::string panel(const Sensitivity& found, const std::vector<std::size_t>& rows, double left, double top,
                  std::size_t title_lines) {
  const Axis axis = axis_of(found, left);
  const double first = top + title_line * static_cast<double>(title_lines) + 6,
               height = row_height * static_cast<double>(rows.size());
  std::string svg;
  const auto title = wrapped(found.what, title_letters);
  for (std::size_t k = 0; k < title.size(); ++k)
    svg += text_at(left, top + title_line * static_cast<double>(k + 1) - 3, "title", "start", title[k]);
  svg += text_at(left, top + title_line * static_cast<double>(title.size() + 1) - 3, "note", "start",
                 "required " + found.wanted);
  const double from = axis.place(std::max(found.range.low, axis.low)),
               to = axis.place(std::min(found.range.high, axis.high));
  svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"band\"/>\n", from,
                     first, to - from, height);
  for (const double tick : ticks(axis)) {
    svg += line(axis.place(tick), first, axis.place(tick), first + height, "grid");
    svg += text_at(axis.place(tick), first + height + 14, "tick", "middle", fmt::format("{:.4g}", tick));
  }
  svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"frame\"/>\n", left,
                     first, panel_width, height);
  svg += line(axis.place(found.entries.front().value.value), first, axis.place(found.entries.front().value.value),
              first + height, "usual");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& entry = found.entries[rows[k]];
    const double y = first + row_height * (static_cast<double>(k) + 0.5), error = entry.value.error;
    if (!std::isfinite(entry.value.value)) continue;
    if (std::isfinite(error))
      svg += line(axis.place(entry.value.value - error), y, axis.place(entry.value.value + error), y, "bar");
    svg += mark(axis.place(entry.value.value), y, entry.outcome);
  }
  return svg;
}

bool is_drawn(const Sensitivity& found) { return !found.wanted.empty() && found.entries.size() > 1; }

bool same_choices(const Sensitivity& a, const Sensitivity& b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                    [](const auto& x, const auto& y) { return x.choice == y.choice; });
}

/// Numbers with the same choices, as many as stand side by side.
using Strip = std::vector<const Sensitivity*>;
std::vector<Strip> strips_of(const validation::Judgement& judgement) {
  std::vector<Strip> strips;
  for (const Sensitivity& found : judgement.sensitivities) {
    if (!is_drawn(found)) continue;
    const auto at = std::find_if(strips.begin(), strips.end(), [&](const Strip& strip) {
      return strip.size() < in_a_strip && same_choices(*strip.front(), found);
    });
    if (at == strips.end()) strips.push_back({&found});
    else at->push_back(&found);
  }
  return strips;
}

/// Choices that one of the numbers is known for.
std::vector<std::size_t> rows_of(const Strip& strip) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < strip.front()->entries.size(); ++k)
    if (std::any_of(strip.begin(), strip.end(),
                    [=](const Sensitivity* found) { return std::isfinite(found->entries[k].value.value); }))
      rows.push_back(k);
  return rows;
}

/// A strip from `top` on; moves `top` below it.
std::string draw(const Strip& strip, double& top) {
  const auto rows = rows_of(strip);
  std::size_t title_lines = 1;
  for (const Sensitivity* found : strip)
    title_lines = std::max(title_lines, wrapped(found->what, title_letters).size() + 1);
  const double first = top + title_line * static_cast<double>(title_lines) + 6;
  std::string svg;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string& choice = strip.front()->entries[rows[k]].choice;
    svg += text_at(edge + label_width - 8, first + row_height * (static_cast<double>(k) + 0.5) + 4,
                   choice.empty() ? "title" : "choice", "end", choice.empty() ? "reference" : choice);
  }
  for (std::size_t k = 0; k < strip.size(); ++k)
    svg += panel(*strip[k], rows, edge + label_width + (panel_width + gap) * static_cast<double>(k), top, title_lines);
  top = first + row_height * static_cast<double>(rows.size()) + 32;
  return svg;
}

std::string legend(double top) {
  std::string svg;
  double x = edge + 8;
  for (const auto& [outcome, words] :
       {std::pair{Outcome::holds, "met"}, {Outcome::undecided, "undecided"}, {Outcome::fails, "not met"}}) {
    svg += mark(x, top, outcome) + text_at(x + 9, top + 4, "note", "start", words);
    x += 100;
  }
  return svg + text_at(x, top + 4, "note", "start", "bars: standard error; shaded: required; dashed: reference");
}

}  // namespace

bool has_dots(const validation::Judgement& judgement) {
  return std::any_of(judgement.sensitivities.begin(), judgement.sensitivities.end(), is_drawn);
}

std::string ledger_dots(const validation::Judgement& judgement) {
  const auto strips = strips_of(judgement);
  std::size_t panels = 1;
  double top = edge;
  std::string body;
  for (const Strip& strip : strips) {
    panels = std::max(panels, strip.size());
    body += draw(strip, top);
  }
  body += legend(top);
  const double width = std::max(2 * edge + label_width + (panel_width + gap) * static_cast<double>(panels), 660.0),
               height = top + edge + 6;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n{2}<rect width=\"100%\" "
      "height=\"100%\" class=\"ground\" rx=\"6\"/>\n{3}</svg>\n",
      width, height, style, body);
}

}  // namespace arenite::validation
