#include "workflow/identify/identify_factor.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/identify/constants.hpp"
#include "workflow/identify/identify_tables.hpp"

namespace arenite::workflow {
namespace {

using identify::Group;
using identify::Identification;
using io::Quantity;
using statistics::Measured;
using Column = std::vector<double>;

const Quantity stress_quantity{
    {"stress", "sigma", "stress_peak_to_peak", "stress_amplitude", "stress_swing"}, dimension::pressure, ""};
const Quantity force_quantity{
    {"force", "f", "force_peak_to_peak", "force_amplitude", "force_swing"}, dimension::force, ""};
const Quantity force_max_quantity{{"force_max", "f_max", "max_force"}, dimension::force, ""},
    force_min_quantity{{"force_min", "f_min", "min_force"}, dimension::force, ""};
const Quantity section_quantity{{"section", "area"}, dimension::area, ""};
const Quantity strain_quantity{{"strain", "eps"}, dimension::none, ""};
const Quantity first_strain_quantity{{"strain_1", "strain_x"}, dimension::none, ""},
    second_strain_quantity{{"strain_2", "strain_y"}, dimension::none, ""};
const Quantity temperature_quantity{
    {"temperature", "dt", "temperature_peak_to_peak", "temperature_amplitude", "temperature_swing"},
    dimension::temperature,
    "",
    Quantity::Kind::difference};
const Quantity signal_quantity{{"signal", "s"}, dimension::none, ""};
constexpr const char* needs =
    "has no columns for a factor; give a cause (stress, or force_min and force_max, or strain) and a response "
    "(temperature or signal), or the properties alpha, temperature, density and heat_capacity";

const char* words_of(AmplitudeConvention convention) {
  return convention == AmplitudeConvention::peak_to_peak ? "peak-to-peak values" : "amplitudes";
}

/// Peak-to-peak stresses, empty where the file has neither stresses nor forces.
Column stresses(io::LaboratoryTable& table, const FactorRequest& request, std::string& way) {
  if (const auto column = table.find(stress_quantity)) {
    way = "stress";
    return identify::peak_to_peak(table.values(*column, stress_quantity), request.load);
  }
  Column force;
  if (const auto high = table.find(force_max_quantity), low = table.find(force_min_quantity); high && low) {
    way = "(F_max - F_min)/section";
    force = table.values(*high, force_max_quantity);
    const Column least = table.values(*low, force_min_quantity);
    for (std::size_t k = 0; k < force.size(); ++k) force[k] -= least[k];
  } else if (const auto column = table.find(force_quantity)) {
    way = "force/section";
    force = identify::peak_to_peak(table.values(*column, force_quantity), request.load);
  } else {
    return {};
  }
  const auto section = table.find(section_quantity);
  if (!section && !request.section)
    throw InputError(table.file(), table.header_line(),
                     "forces need the specimen's section; give a column \"section [mm^2]\" or " + option("section") +
                         " \"30.9 mm x 4.9 mm\"");
  const Column area = section ? table.values(*section, section_quantity) : Column(force.size(), *request.section);
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (!(area[k] > 0))
      throw InputError(table.file(), table.line(k), "the section is not above 0; give the area that carries the force");
    force[k] /= area[k];
  }
  return force;
}

/// Peak-to-peak sums of both in-plane strains, or empty.
Column strains(io::LaboratoryTable& table, const FactorRequest& request) {
  Column strain;
  if (const auto column = table.find(strain_quantity)) {
    strain = table.values(*column, strain_quantity);
  } else if (const auto one = table.find(first_strain_quantity), two = table.find(second_strain_quantity); one && two) {
    strain = table.values(*one, first_strain_quantity);
    const Column other = table.values(*two, second_strain_quantity);
    for (std::size_t k = 0; k < strain.size(); ++k) strain[k] += other[k];
  } else {
    return {};
  }
  if (!request.young || !request.poisson)
    throw InputError(table.file(), table.header_line(),
                     "strains need the modulus and Poisson's ratio of the specimen; give " + option("young") +
                         " \"2.8 +- 0.1 GPa\" " + option("poisson") + " \"0.35 +- 0.02\"");
  return identify::peak_to_peak(std::move(strain), request.load);
}

Column picked(const Column& from, const RowGroup& group) {
  return mapped(group.rows, [&](std::size_t row) { return from[row]; });
}

[[noreturn]] void refuse_fit(const io::LaboratoryTable& table, const RowGroup& group, bool through_origin) {
  const std::string of = group.name.empty() ? "" : group.name + ": ";
  if (group.rows.size() <= (through_origin ? 1U : 2U))
    throw refusal_at(table.file(), table.line(group.rows.back()),
                     "{}{} points are too few for a slope with an error; give at least {}", of, group.rows.size(),
                     through_origin ? "two" : "three, or " + option("through-origin"));
  throw InputError(
      table.file(), table.line(group.rows.front()),
      of + "the load is the same in every row, or there is no response to it; give tests at several loads");
}

/// The findings of one slope: what it is, and its intercept.
void put_slope(Group& group, Identification& found, const identify::SlopeFound& slope) {
  group.findings.push_back({slope.constant, slope.factor.factor});
  if (auto intercept = identify::intercept_of(slope)) group.findings.push_back(std::move(*intercept));
  if (identify::misses_origin(slope.factor))
    found.notes.push_back(
        fmt::format("{}: the line misses the origin beyond its error; check whether the response is linear in the load",
                    group.name));
}

/// `value` of the factor, a copy: it may stand in the group that grows.
void put_direct(Group& group, const FactorRequest& request, const Measured value) {
  if (!request.detector) return;
  for (auto& finding : identify::direct_findings(*request.detector, value))
    group.findings.push_back(std::move(finding));
}

void put_group(const io::LaboratoryTable& table, const RowGroup& rows, const identify::CausesAndResponses& columns,
               const FactorRequest& request, Identification& found) {
  Group group{rows.name.empty() ? "all" : rows.name, rows.rows.size(), {}};
  const auto of = [&](const Column& column) { return column.empty() ? column : picked(column, rows); };
  const identify::CausesAndResponses tests{of(columns.stress), of(columns.strain), of(columns.temperature),
                                           of(columns.signal)};
  const auto specimen =
      tests.strain.empty() ? std::nullopt : std::optional(identify::Elastic{*request.young, *request.poisson});
  const auto slopes = identify::factors_of(tests, specimen, request.through_origin);
  for (const auto& slope : slopes)
    if (const double value = slope.factor.factor.value; !std::isfinite(value) || !(value > 0))
      refuse_fit(table, rows, request.through_origin);
  const auto put = [&](bool warms) {
    for (const auto& slope : slopes)
      if (slope.of_temperature == warms) put_slope(group, found, slope);
  };
  put(true);
  if (!tests.temperature.empty()) put_direct(group, request, group.findings.front().value);
  put(false);
  found.groups.push_back(std::move(group));
}

void from_properties(io::LaboratoryTable& table, const FactorRequest& request, Identification& found) {
  struct Property {
    Measured identify::Properties::*member;
    Quantity quantity, error;
  };
  const std::vector<Property> properties{
      {&identify::Properties::expansion,
       {{"expansion", "alpha"}, dimension::none / dimension::temperature, ""},
       {{"expansion_error", "alpha_error"}, dimension::none / dimension::temperature, ""}},
      {&identify::Properties::temperature,
       {{"temperature", "t0", "t_0"}, dimension::temperature, "", Quantity::Kind::absolute_temperature},
       {{"temperature_error", "t0_error", "t_0_error"}, dimension::temperature, "", Quantity::Kind::difference}},
      {&identify::Properties::density,
       {{"density", "rho"}, dimension::density, ""},
       {{"density_error", "rho_error"}, dimension::density, ""}},
      {&identify::Properties::heat_capacity,
       {{"heat_capacity", "cp", "c_p"}, dimension::energy / dimension::mass / dimension::temperature, ""},
       {{"heat_capacity_error", "cp_error", "c_p_error"},
        dimension::energy / dimension::mass / dimension::temperature,
        ""}}};
  std::vector<identify::Properties> rows(table.rows());
  for (const auto& p : properties) {
    const auto column = table.find(p.quantity), error = table.find(p.error);
    const std::string name(p.quantity.names.front());
    if (!column)
      throw refusal_at(table.file(), table.header_line(), "there is no column {}; the factor is alpha T_0/(rho c_p)",
                       name);
    const Column values = table.values(*column, p.quantity),
                 errors = error ? table.values(*error, p.error) : Column(table.rows(), statistics::unknown);
    if (!error) found.notes.push_back(fmt::format("{} has no error (column {}_error); none is assumed", name, name));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (!(values[r] > 0))
        throw refusal_at(table.file(), table.line(r), "{} is {}; it must be above 0", name, values[r]);
      rows[r].*p.member = {values[r], errors[r]};
    }
  }
  for (const auto& group : groups_of(table)) {
    for (const std::size_t row : group.rows) {
      const Measured of_properties = identify::factor_from_properties(rows[row]);
      Group one{group.rows.size() > 1 || group.name.empty()
                    ? fmt::format("{}line {}", group.name.empty() ? "" : group.name + ", ", table.line(row))
                    : group.name,
                1,
                {identify::factor_finding(of_properties)}};
      put_direct(one, request, of_properties);
      found.groups.push_back(std::move(one));
    }
  }
}

}  // namespace

Identification identify_factor(const std::string& file, const FactorRequest& request) {
  io::LaboratoryTable table(file);
  Identification found{"factor", file, {}};
  if (table.find(Quantity{{"expansion", "alpha"}, dimension::none / dimension::temperature, ""})) {
    from_properties(table, request, found);
  } else {
    const auto temperature_column = table.find(temperature_quantity), signal_column = table.find(signal_quantity);
    std::string way;
    identify::CausesAndResponses columns{stresses(table, request, way), strains(table, request), {}, {}};
    if ((!temperature_column && !signal_column) || (columns.stress.empty() && columns.strain.empty()))
      throw InputError(file, table.header_line(), needs);
    const auto response = [&](const auto& column, const Quantity& quantity) {
      return column ? identify::peak_to_peak(table.values(*column, quantity), request.temperature) : Column{};
    };
    columns.temperature = response(temperature_column, temperature_quantity);
    columns.signal = response(signal_column, signal_quantity);
    for (const auto& group : groups_of(table)) put_group(table, group, columns, request, found);
    if (!columns.stress.empty()) found.notes.push_back("the stress is " + way);
    found.notes.push_back(
        fmt::format("responses are taken as {}, loads as {}; the factor is that of peak-to-peak values (maximum minus "
                    "minimum) on both sides, as the thesis's: give {} amplitude for the amplitudes of a sine",
                    words_of(request.temperature), words_of(request.load), option("temperature-convention")));
  }
  return finished(std::move(found), table, request.stated);
}

}  // namespace arenite::workflow
