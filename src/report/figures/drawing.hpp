#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "statistics/numbers.hpp"
#include "statistics/written.hpp"

/// What figures show, once for the page and for print. Labels are written as "F_{n}", "\u03c3_{norm}" (notation).
namespace arenite::report::figures {

struct Axis {
  std::string label = {};
  std::string unit = {};   ///< as it is printed, with the prefix that the numbers are scaled by
  std::string brief = {};  ///< a shorter label, for what the pointer tells and for tables
  bool logarithmic = false;
  std::optional<double> low = {}, high = {};  ///< what lies outside is not drawn
  std::vector<std::string> names = {};        ///< of categories, whose numbers are 0, 1, ...; the first is on top
};

enum class Line { none, solid, dashed, dotted };

/// Numbers of one kind against each other. A colour is a role that each renderer has a colour for: "strong", "weak",
/// "soft", "accent", "fit", "tension", "wall"; "material 0", "mixed 0" (contacts between two), "line 0" (one of many),
/// "set large" (nodes of this kind), "crack 1", "broken 0" (bonds by how they break); "scale 0.5" (of values in an
/// order, from 0 to 1), "source" (what a text says).
struct Series {
  std::string name = {}, colour = "strong";
  std::vector<double> x = {}, y = {};
  std::vector<double> error = {};           ///< standard error of y; empty: none
  std::vector<double> low = {}, high = {};  ///< ends of a band, also about a line, or of bars along y
  Line line = Line::none;
  bool points = false;
  std::string mark = {};  ///< of points: "hollow", "diamond", "times", "plus"; empty: a dot
  bool steps = false;     ///< the line keeps its value up to the next point
  double bars = 0;        ///< width of bars about x
  double weight = 1, opacity = 1;
  bool is_read = true;               ///< the pointer tells its points, and tables hold them
  std::string each = {};             ///< what a point is: "step" (counted from 1), "grain", "contact"
  std::vector<double> members = {};  ///< which grain (its id) or contact each point is
};

/// A line across at y, or upright at x, a cross at both, or a line through the origin of this slope.
struct Reference {
  std::optional<double> x = {}, y = {}, slope = {};
  std::string label = {};
  std::string colour = "soft";
  Line line = Line::dotted;
};

/// Where the page marks what its reader has chosen: one place for each state of the run, the stage or the test. An
/// upright line, or with y a dot.
struct Chosen {
  std::vector<double> x = {}, y = {};
};

struct Panel {
  Axis x = {}, y = {};
  std::vector<Series> series = {};
  std::vector<Reference> references = {};
  std::vector<std::string> corner = {};  ///< lines of text in the upper left corner
  Chosen now = {};
  std::string selected = {};  ///< what stands at x: "diameter" (mm) or "sigma_norm" of a grain that is selected
  std::string click = {};     ///< what a click on a point chooses: "step"
  bool lying = false;         ///< bars lie, one for each of y's names
  bool near = false;          ///< the pointer tells the point that is nearest, not the one nearest along x
  bool square = false;        ///< both axes are of the same numbers
};

/// A polar histogram of directions over half a turn.
struct Rose {
  std::string name = {}, colour = {};
  double count = 0;
  std::vector<double> sectors = {}, inner = {};  ///< contacts over the isotropic number; a part of them, drawn darker
  std::vector<double> line = {};        ///< radii of 1 + a cos 2(theta - direction) by equal angles of half a turn
  double axis = statistics::unknown;    ///< which is marked, degrees
  double reach = 1.6;                   ///< of the outer circle, over isotropic
  std::vector<std::string> words = {};  ///< below
};

/// Numbers by direction in space over half of the sphere.
struct Hemisphere {
  std::string name = {};
  double count = 0;
  std::vector<double> values = {};      ///< of each sector
  std::vector<double> mark = {};        ///< x and y of the direction of most; empty: none
  std::vector<std::string> words = {};  ///< below
};

/// Halves of the sphere side by side, in the same sectors of rings of a projection that keeps areas, seen from above
/// with x to the right and z below.
struct Hemispheres {
  std::vector<Hemisphere> sets = {};
  std::vector<double> inner = {}, outer = {};  ///< radii of each sector, 1 on the rim
  std::vector<double> from = {}, to = {};      ///< degrees counter-clockwise from the right
  double reach = 1;                            ///< the end of the scale of colours, which begins at 0
  std::string measure = {};                    ///< what the scale says
};

/// Outlines of numbers by direction over half a turn, which is mirrored: each series over the middles of its sectors,
/// degrees, with ticks for its errors.
struct Outlines {
  std::vector<Series> series = {};
  std::vector<double> rings = {};  ///< which are labelled
  double reach = 1;                ///< of the outermost place
  bool isotropic = false;          ///< the ring at 1 is that of no preferred direction
  std::string corner = {};
};

/// A number over two others as colour, and written: one for each name of x, row by row of the names of y from below.
struct Cells {
  Axis x = {}, y = {};
  std::vector<double> values = {}, error = {};  ///< NaN where there is none
};

/// A number of grains that may stand along an axis (texture/grain_quantities.hpp): each grain's over `factor`.
struct GrainAxis {
  std::string quantity = {}, words = {};
  Axis axis = {};
  double factor = 1;
};

/// A point for each grain of a state, in the colour of its material, which is a state's own and not repeated here: any
/// of these numbers against any other.
struct Scatter {
  std::vector<GrainAxis> axes = {};
  std::string across = {}, up = {};  ///< what is shown first, and in print
  std::size_t every = 1;             ///< one in so many grains is drawn
};

/// A number in the key, as it is written.
struct Said {
  std::string symbol = {}, value = {}, error = {};
};
struct KeyEntry {
  std::string name = {}, colour = {};
  std::vector<Said> numbers = {};
  Line line = Line::solid;
  int counts =
      -1;  ///< the series of the first panel whose value at the chosen step, or at the end, stands behind the name
  std::string mark = {};  ///< instead of a line, as of series
};

/// One drawing of a figure: panels side by side, or roses, hemispheres, outlines, cells or a scatter of grains. A
/// figure that follows choices has one for each.
struct Drawing {
  std::vector<std::pair<std::string, std::string>> chosen = {};  ///< {"component", "xx"}
  std::vector<Panel> panels = {};
  std::vector<Rose> roses = {};
  std::vector<KeyEntry> key = {};
  std::optional<Hemispheres> hemispheres = {};
  std::optional<Outlines> outlines = {};
  std::optional<Cells> cells = {};
  std::optional<Scatter> scatter = {};
  std::string note = {};  ///< a sentence of what is not drawn, and why
};
using Drawings = std::vector<Drawing>;

struct Option {
  std::string value = {}, words = {};
  std::string file = {};  ///< what the name of its file in print ends with, where it has one of its own
};

/// Something that the reader of the page chooses. Print shows all of it in one figure, a file for each of it, or the
/// first.
struct Choice {
  enum class Print { together, files, first };
  std::string key = {}, label = {};
  std::vector<Option> options = {};
  Print print = Print::together;
  bool has_buttons = true;  ///< else it is chosen elsewhere on the page
};

/// What stands below a figure: what it shows, whoever draws it, and how to read it where it stands alone.
struct Caption {
  std::string shown, details;
  Caption(const char* what = "", const char* how = "") : shown(what), details(how) {}
  std::string whole() const { return details.empty() ? shown : shown + " " + details; }
};

/// What is said of a figure whatever it shows: id on the page, name in print.
struct Head {
  std::string id = {}, name = {}, title = {};
  Caption caption = {};
  bool wide = false;
  std::vector<Choice> choices = {};
  bool nearest = false;  ///< of a stage that has none the page shows that of the stage before it, or of the next
};

/// A figure in a list: its head, and what it shows of the data; nothing where there is nothing to draw.
template <class Data> struct Row {
  Head head;
  Drawings (*draw)(const Data& data);
};

// Words and numbers.

/// How quantities are written, as a regular expression of JavaScript and Python alike: "_{n}" is lowered, "^{2}"
/// raised, and a letter before a lowered index is in italics. Its groups: that letter, the mark, and what is lowered or
/// raised.
inline constexpr const char* notation = "(\\b[A-Za-z]|[\u0370-\u03ff])?([_^])\\{([^}]*)\\}";

using statistics::Scale;
using statistics::scale_of;
/// The same of the largest of these.
Scale scale_of(const std::vector<double>& values, const std::string& unit);

/// "0.123", "0.029": both to the second digit of the error; without an error four digits.
Said said(std::string symbol, const statistics::Estimate& estimate);
/// The same with the prefix of the unit that suits it, and the unit behind.
Said said_in_unit(std::string symbol, const statistics::Estimate& estimate, const std::string& unit);
/// "a_{c} = 0.12 \u00b1 0.03".
std::string in_words(const Said& number);
/// Whole, with thin blanks between thousands.
std::string counted(double value);
/// With as many significant digits.
std::string rounded(double value, int digits);
std::string between_dashes(std::string key);  ///< "POM-HDPE" with an en dash

// Reading a tree of numbers.

/// {value, error} of what lies at a path as a number or an estimate; unknown where there is none.
statistics::Estimate estimate_at(const Numbers& tree, std::string_view path);
/// A list of numbers at a path; empty where there is none; NaN for what is not known.
std::vector<double> reals_at(const Numbers& tree, std::string_view path);

// Numbers of series.

std::vector<double> scaled(std::vector<double> values, double factor);
double largest_of(const std::vector<double>& values, double otherwise);  ///< of those that are finite
double least_above_zero(const std::vector<double>& values, double otherwise);
/// A function at evenly spaced places from `from` to `to`.
template <class F>
std::pair<std::vector<double>, std::vector<double>> sampled(double from, double to, F f, int count = 60) {
  std::pair<std::vector<double>, std::vector<double>> out;
  for (int k = 0; k <= count; ++k) {
    out.first.push_back(from + (to - from) * k / count);
    out.second.push_back(f(out.first.back()));
  }
  return out;
}
/// A logarithmic axis of whole decades about these values.
Axis decades_about(std::string label, double low, double high);

}  // namespace arenite::report::figures
