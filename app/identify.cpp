#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "print.hpp"
#include "workflow/identify_curves.hpp"
#include "workflow/identify_factor.hpp"

namespace arenite::app {
namespace {

using statistics::Measured;

struct IdentifyArguments {
  std::string what, file, stated;
  std::string preload = "1 kN", branch = "loading", length;  // stiffness
  std::string k, radius, effective_radius = "four_reduced";  // adhesion
  std::string section, young, poisson, temperature_convention = "peak-to-peak",
                                       load_convention = "peak-to-peak";  // factor
  std::string responsivity, amplification = "1", emissivity = "1", reference = "296 K", surface = "296 K",
                            band = "3.6 um,5.1 um";
  bool through_origin = false, json = false;
};

double si(const char* option, const std::string& text, Dimension dimension, const char* unit,
          bool zero_allowed = false) {
  const double value = option_value(option, [&] { return parse_si(text, dimension, unit); });
  if (!(value > 0) && !(zero_allowed && value == 0))
    throw InputError(std::string(option) + ": \"" + text + "\" must be " + (zero_allowed ? "0 or above" : "above 0"));
  return value;
}

/// "27.35 kN/mm" or, with a standard error, "27.35 +- 0.40 kN/mm".
Measured measured(const char* option, const std::string& text, Dimension dimension, const char* unit) {
  const auto sign = text.find("+-");
  if (sign == std::string::npos) return {si(option, text, dimension, unit)};
  const std::string error = trimmed(text.substr(sign + 2));
  const auto unit_at = error.find(' ');
  const std::string behind = unit_at == std::string::npos ? "" : error.substr(unit_at);
  return {si(option, trimmed(text.substr(0, sign)) + behind, dimension, unit),
          si(option, error, dimension, unit, true)};
}

/// Two lengths of "a,b", or twice the one.
std::pair<double, double> two_lengths(const char* option, const std::string& text, const char* unit) {
  const auto comma = text.find(',');
  const double first = si(option, trimmed(text.substr(0, comma)), dimension::length, unit);
  return {first,
          comma == std::string::npos ? first : si(option, trimmed(text.substr(comma + 1)), dimension::length, unit)};
}

/// "151.4 mm^2" or "30.9 mm x 4.9 mm".
double section(const std::string& text) {
  const auto times = text.find(" x ");
  if (times == std::string::npos) return si("--section", text, dimension::area, "mm^2");
  return si("--section", trimmed(text.substr(0, times)), dimension::length, "mm") *
         si("--section", trimmed(text.substr(times + 3)), dimension::length, "mm");
}

identify::Identification stiffness(const IdentifyArguments& a) {
  workflow::StiffnessRequest request;
  request.curve = {si("--preload", a.preload, dimension::force, "kN", true),
                   a.branch == "unloading" ? identify::Branch::unloading : identify::Branch::loading};
  if (!a.length.empty()) request.length = si("--length", a.length, dimension::length, "mm");
  request.stated = a.stated;
  return workflow::identify_stiffness(a.file, request);
}

identify::Identification adhesion(const IdentifyArguments& a) {
  workflow::AdhesionRequest request;
  if (!a.k.empty()) request.stiffness = measured("--k", a.k, dimension::stiffness, "kN/mm");
  if (!a.radius.empty()) request.radii = two_lengths("--radius", a.radius, "mm");
  if (a.effective_radius == "sum") request.effective_radius = identify::EffectiveRadius::sum;
  if (a.effective_radius == "geometric_mean") request.effective_radius = identify::EffectiveRadius::geometric_mean;
  request.stated = a.stated;
  return workflow::identify_adhesion(a.file, request);
}

identify::Identification factor(const IdentifyArguments& a) {
  workflow::FactorRequest request;
  if (!a.section.empty()) request.section = section(a.section);
  if (!a.young.empty()) request.young = measured("--young", a.young, dimension::pressure, "GPa");
  if (!a.poisson.empty()) request.poisson = measured("--poisson", a.poisson, dimension::none, "");
  if (request.poisson && !(request.poisson->value < 1)) throw InputError("--poisson: must be below 1");
  if (a.temperature_convention == "amplitude") request.temperature = AmplitudeConvention::amplitude;
  if (a.load_convention == "amplitude") request.load = AmplitudeConvention::amplitude;
  request.through_origin = a.through_origin;
  if (!a.responsivity.empty()) {
    identify::Detector d;
    d.responsivity = measured("--responsivity", a.responsivity, dimension::temperature, "K");
    d.amplification = measured("--amplification", a.amplification, dimension::none, "");
    d.emissivity = measured("--emissivity", a.emissivity, dimension::none, "");
    if (d.emissivity.value > 1) throw InputError("--emissivity: must be at most 1");
    d.reference = si("--responsivity-at", a.reference, dimension::temperature, "K");
    d.surface = si("--surface-at", a.surface, dimension::temperature, "K");
    const auto [low, high] = two_lengths("--band", a.band, "um");
    if (!(high > low))
      throw InputError("--band: give two wavelengths, the shorter one first, for example \"3.6 um,5.1 um\"");
    d.band = {low, high};
    request.detector = d;
  }
  request.stated = a.stated;
  return workflow::identify_factor(a.file, request);
}

void add_mechanical(Options& command, IdentifyArguments& a) {
  command.add("--preload", a.preload, "Stiffness: use only data above this force; default \"1 kN\"").type("FORCE");
  command.add("--branch", a.branch, "Stiffness: part of a record's cycles that is fitted; default loading")
      .among({"loading", "unloading"})
      .type("BRANCH");
  command
      .add("--length", a.length,
           "Stiffness: length of the cylinders, e.g. \"60 mm\", for the stiffness per unit length")
      .type("LENGTH");
  command.add("--k", a.k, "Adhesion: contact stiffness of the pair, e.g. \"27.35 kN/mm\" or \"27.35 +- 0.40 kN/mm\"")
      .type("STIFFNESS");
  command
      .add("--radius", a.radius, "Adhesion: common radius of the cylinders, or the radius of each: \"6.2 mm,8.2 mm\"")
      .type("R[,R]");
  command
      .add("--effective-radius", a.effective_radius,
           "Adhesion: r_eff of unequal radii: 4 r_i r_j/(r_i + r_j) (default), r_i + r_j or 2 sqrt(r_i r_j)")
      .among({"four_reduced", "sum", "geometric_mean"})
      .type("NAME");
}

void add_thermal(Options& command, IdentifyArguments& a) {
  command
      .add("--section", a.section,
           "Factor: cross-section that carries the force, \"30.9 mm x 4.9 mm\" or \"151.4 mm^2\"")
      .type("AREA");
  command.add("--young", a.young, "Factor from strains: modulus of the specimen, e.g. \"2.8 +- 0.1 GPa\"")
      .type("MODULUS");
  command.add("--poisson", a.poisson, "Factor from strains: Poisson's ratio, e.g. \"0.35 +- 0.02\"").type("NUMBER");
  const auto convention = [&](const char* name, const char* former, std::string& to, const char* sentence) {
    command.add(name, to, sentence)
        .among({"peak-to-peak", "amplitude"})
        .formerly("full", "peak-to-peak")
        .formerly("half", "amplitude")
        .formerly(former);
  };
  convention("--temperature-convention", "--temperature-swing", a.temperature_convention,
             "Factor: whether temperatures and signals are peak-to-peak values (default) or amplitudes of a sine");
  convention("--load-convention", "--load-swing", a.load_convention,
             "Factor: whether stresses, forces and strains are peak-to-peak values (default) or amplitudes; force_max "
             "- force_min is always peak to peak");
  command.add("--through-origin", a.through_origin, "Factor: force the line through the origin");
}

void add_detector(Options& command, IdentifyArguments& a) {
  command
      .add("--responsivity", a.responsivity,
           "Factor: responsivity D of the detector in K per level, for the constant A' = D R F/(T eps A) of a raw "
           "signal")
      .type("K");
  command.add("--responsivity-at", a.reference, "Temperature at which D was measured; default \"296 K\"")
      .type("TEMPERATURE");
  command.add("--surface-at", a.surface, "Temperature of the specimen; default \"296 K\"").type("TEMPERATURE");
  command.add("--amplification", a.amplification, "Amplification factor F of the signal; default 1").type("NUMBER");
  command.add("--emissivity", a.emissivity, "Emissivity of the specimen; default 1").type("NUMBER");
  command.add("--band", a.band, "Wavelength band of the detector; default \"3.6 um,5.1 um\"").type("LOW,HIGH");
}

}  // namespace

void add_identify(Options& command, int&) {
  const auto a = std::make_shared<IdentifyArguments>();
  command.add("what", a->what, "Quantity to identify")
      .required()
      .among({"stiffness", "factor", "adhesion"})
      .type("WHAT");
  command
      .add("file", a->file,
           "CSV of records or a table, with units in its header: displacement and force; stress or strain and "
           "temperature; or values by group")
      .required()
      .type("FILE");
  add_mechanical(command, *a);
  add_thermal(command, *a);
  add_detector(command, *a);
  command.add("--stated", a->stated, "Table of the values that a source states for the same groups, for comparison")
      .type("FILE");
  command.add("--json", a->json, "Print JSON in SI units: value, error, confidence_95");
  command.work = [a] {
    const auto found = a->what == "stiffness" ? stiffness(*a) : a->what == "adhesion" ? adhesion(*a) : factor(*a);
    put(stdout, a->json ? to_json(identify::numbers(found), 1) + "\n" : identify::to_text(found));
  };
}

}  // namespace arenite::app
