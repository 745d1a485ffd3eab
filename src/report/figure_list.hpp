#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::report {

/// An axis of a figure.
struct FigureAxis {
  std::string label;
  bool logarithmic = false;
  std::optional<double> low, high;  ///< unless given, as far as the points reach
  std::string unit = {};            ///< behind the label; of a label that is declared it is part of it
  double factor = 1;                ///< of that unit, by which numbers are divided
};

/// What the text of the source says of a figure: a level, an abscissa or, with both, a point; or a line through the
/// origin.
struct FigureReference {
  std::optional<double> x, y, slope;
  std::string label;
};

/// Points that the source gives, in a table or in its text; drawn as crosses in the colour of what they stand beside.
struct SourcePoints {
  std::string name;
  std::optional<std::int64_t> part;  ///< which of `y` or `curves`, from 0
  bool film = false;                 ///< what the source measured, where it also simulated
  std::vector<double> x, y;
};

/// A curve beside those of a figure, of other runs or another number.
struct BesideCurve {
  std::string name, x, y;
  Wanted where;  ///< runs that count: those with one of these values of these keys
};

/// What bars show of the scatter over samples: the standard error of the mean or the standard deviation.
enum class Spread { error, deviation };

/// How a figure is drawn: points and lines; `curves` as sectors of directions over half a turn; `y` as a colour over x
/// and `by`; or one run's state: its grains, their forces, their stresses, the stresses that a film of it gives, its
/// phases on the grid, the stresses of nodes in and about one grain, or its broken bonds.
enum class FigureKind { plot, rose, map, grains, forces, stresses, film, phases, zoom, cracks };
const char* word_for(FigureKind kind);
/// Whether it shows one run.
constexpr bool shows_a_run(FigureKind kind) { return kind >= FigureKind::grains; }

/// A figure of a study, as figures.toml declares it. Its points are runs, averaged over those that differ in their seed
/// alone, or its curves are densities.
struct Figure {
  std::string id, title, source, caption;
  std::string x;                    ///< a swept key or a number; "1/NAME", "27.35/NAME" for a number over it
  std::vector<std::string> y;       ///< numbers ("stress.sigma_yy.sets.large.variance")
  std::vector<std::string> curves;  ///< instead of x and y: densities or lists of the runs' numbers
  std::string curve_x;              ///< a list that those of `curves` go with, place by place
  std::vector<std::string> fits;    ///< of `curves`: exponential tails of the runs' numbers, {"slope", "low", "high"}
  bool survival = false;            ///< of densities, the survival function: the share above x
  bool counts = false;              ///< of a rose: contacts of a sample, not their share
  std::optional<std::int64_t> sectors;  ///< of a rose: into how many; as many as the runs have unless given
  std::optional<double> window;         ///< share of the box's area of the windows in "window.solid_fraction"
  Spread spread = Spread::error;
  std::string stage;  ///< whose last state is shown; the last one's unless given
  FigureKind kind = FigureKind::plot;
  std::vector<std::string> names;  ///< of y or of curves, as the key shows them
  std::string by, by_label;        ///< a swept key: a curve for each of its values
  std::string by_empty;            ///< how the key shows runs without that value
  bool lines = true;               ///< points are joined
  FigureAxis x_axis, y_axis;
  Wanted where;  ///< runs that count: those with one of these values of these keys
  std::vector<FigureReference> references;
  std::vector<SourcePoints> source_points;
  std::vector<BesideCurve> beside;
};

void declare(ParameterVisitor& visitor, Figure& figure);

/// The reference of all keys of figures.toml, in Markdown.
std::string figure_key_reference();

/// Reads figures.toml. Former names of keys and of numbers count as those of now; each adds a sentence to `notices`.
/// Throws InputError with every problem.
std::vector<Figure> read_figures(const std::string& text, const std::string& file,
                                 std::vector<std::string>* notices = nullptr);

}  // namespace arenite::report
