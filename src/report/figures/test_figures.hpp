#pragma once
#include <optional>
#include <string>
#include <vector>

#include "grains/fields/test_curves.hpp"
#include "report/figures/stage_figures.hpp"
#include "statistics/columns.hpp"

namespace arenite::report::figures {

/// Stress ratio, or stress, and volumetric strain, or pressure, against the strain of a test.
Drawings test_curves(const StageData& data);
Drawings test_curves(const SphereResult& stage);

inline constexpr double largest_ratio = 2;  ///< of stresses; beyond it the sides are all but unloaded
std::vector<double> known_up_to(std::vector<double> values, double most);

/// What strains of a test are multiplied by: those of sides are in per cent, shear strains are numbers.
double factor_of(const fields::TestCurves& curves);
/// A panel over the strain of a test, with the place of each state.
Panel against_strain(const fields::TestCurves& curves, const StageData& data, Axis y);

/// "axial_strain_maximum" as words, with the symbols that quantities have.
std::string words_of(std::string name);

/// How a curve of a test (fields::loading_of and the like) is drawn: its axis, and what its numbers are divided by.
struct CurveAxis {
  Axis axis;
  double factor = 1;
};
CurveAxis axis_of(const statistics::Column& column);

/// A line; one of many rows, which fluctuates, is pale under its running mean.
void add_curve(Panel& panel, const std::vector<double>& x, const std::vector<double>& y, const std::string& colour);
void add_curve(Panel& panel, const std::vector<double>& x, std::vector<double> y, std::vector<double> mean,
               const std::string& colour);

/// One curve of a test, or column of its history, against another, with the place of each state; "test" twice: the
/// ratio of stresses against the strain, which spheres that are no test have not. Throws InputError for a name that the
/// stage has not.
Panel one_against_another(const StageData& data, const std::string& x, const std::string& y);
std::optional<Panel> one_against_another(const SphereResult& stage, const std::string& x, const std::string& y);

}  // namespace arenite::report::figures
