#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/table/table.hpp"
#include "model/film.hpp"
#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"

/// What the three identifications share: columns that are labels, rows put together by them, and stated values.

namespace arenite::workflow {

struct StiffnessRequest {
  identify::StiffnessOptions curve;
  std::optional<double> length;  ///< of the cylinders, m; gives the stiffness of a unit of length too
  std::string stated;            ///< file of what a source states for the same groups; or empty
};

/// Contact stiffness of every group of a file. Records (columns displacement, force; perhaps a group and a test) are
/// cut into cycles; tables hold slopes already found, one a row (column stiffness) or a column a group. A group's error
/// is the scatter of its tests; of a single test, that of its slope. Throws InputError with file and line.
identify::Identification identify_stiffness(const std::string& file, const StiffnessRequest& request);

struct AdhesionRequest {
  std::optional<statistics::Measured> stiffness;   ///< of the pair, N/m
  std::optional<std::pair<double, double>> radii;  ///< of both cylinders, m
  identify::EffectiveRadius effective_radius = identify::EffectiveRadius::four_reduced;
  std::string stated;
};

/// Separation force and, where stiffness and radii are given, surface energy of every group of a file: pull-off records
/// (columns displacement or time, force) or tables of separation forces, one a row or a column a group.
identify::Identification identify_adhesion(const std::string& file, const AdhesionRequest& request);

struct FactorRequest {
  std::optional<double> section;                       ///< of the specimen, m^2, where the file gives forces
  std::optional<statistics::Measured> young, poisson;  ///< where it gives strains
  /// How the file gives temperatures and signals, and stresses, forces and strains.
  AmplitudeConvention temperature = AmplitudeConvention::peak_to_peak, load = AmplitudeConvention::peak_to_peak;
  bool through_origin = false;
  std::optional<identify::Detector> detector;  ///< for the constant of a raw signal
  std::string stated;
};

/// Thermoelastic factor A of every group (material) of a file, by what its columns allow: stress or force against
/// temperature, strain against temperature, or alpha, T_0, rho and c_p; the constant A' where a raw signal stands for
/// the temperature.
identify::Identification identify_factor(const std::string& file, const FactorRequest& request);

namespace quantity {
inline const io::Quantity force{{"force", "f", "load"}, dimension::force, ""};
inline const io::Quantity displacement{{"displacement", "delta", "extension"}, dimension::length, ""};
inline const io::Quantity time{{"time", "t"}, dimension::time, ""};
}  // namespace quantity

/// The rows of one group, in the order of the file.
struct RowGroup {
  std::string name;
  std::vector<std::size_t> rows;
};

/// Rows by the column group, material, glue or diameter; one group without a name where there is none.
std::vector<RowGroup> groups_of(const io::LaboratoryTable& table);

/// The records of a group, one a test.
struct RecordGroup {
  std::string name;
  std::vector<identify::Curve> tests;
};
/// The tests of a group by name, each with what it measured.
struct TestGroup {
  std::string name;
  std::vector<std::pair<std::string, statistics::Measured>> tests;
};
/// What is said of a value that is not above 0.
using Refusal = std::function<std::string(const std::string& group, const std::string& test, double value)>;
/// How the tests of a file are found: in `records` of force against the first of these quantities that it has, each
/// group of them by `cut`; or as values that it holds, one a row, or a column a group. A file of neither kind is
/// refused by what it `needs`.
struct TestsWanted {
  std::vector<io::Quantity> against;
  std::function<decltype(TestGroup::tests)(const RecordGroup&)> cut;
  io::Quantity tabulated;
  const char* needs;
  Refusal refusal;
};
std::vector<TestGroup> tests_in(io::LaboratoryTable& table, const TestsWanted& wanted);

/// Adds the table's notes to what was found, and puts what the file `stated` (or none) says beside the findings of the
/// same name: its first column names a group, or "all".
identify::Identification finished(identify::Identification found, const io::LaboratoryTable& table,
                                  const std::string& stated);

}  // namespace arenite::workflow
