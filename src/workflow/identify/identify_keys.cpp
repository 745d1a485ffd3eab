#include "workflow/identify/identify_keys.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "model/lockin_maps.hpp"
#include "recipe/film_keys.hpp"

namespace arenite::workflow {
namespace {

using Visitor = ParameterVisitor;
using statistics::Measured;

/// A value, perhaps with its standard error: one or two numbers. Returns what is there.
std::optional<Measured> measured(Visitor& v, const Key& key, const std::optional<Measured>& value,
                                 std::string_view unit, double most = HUGE_VAL) {
  std::vector<double> parts;
  if (value) parts = {value->value};
  if (value && value->error > 0) parts.push_back(value->error);
  v.numbers(key, parts, unit, range::not_negative);
  const bool right = parts.size() <= 2 && (parts.empty() || (parts[0] > 0 && parts[0] <= most));
  v.require(right, {key.name},
            parts.size() > 2 ? "must be a value, or a value and its standard error"
                             : "must be " + to_string(range::above(0, most), unit));
  if (!right || parts.empty()) return std::nullopt;
  return Measured{parts[0], parts.size() == 2 ? parts[1] : 0};
}

/// The same of what has a value in any case.
void measured(Visitor& v, const Key& key, Measured& value, double most = HUGE_VAL) {
  value = measured(v, key, std::optional(value), "", most).value_or(value);
}

void declare_detector(Visitor& v, std::optional<identify::Detector>& detector) {
  identify::Detector d = detector.value_or(identify::Detector{});
  const std::optional<Measured> given = detector ? std::optional(d.responsivity) : std::nullopt;
  const auto responsivity = measured(v,
                                     {"responsivity",
                                      "Responsivity D of the detector per level, for the constant A' = D R F/(T eps A) "
                                      "of a raw signal."},
                                     given, "K");
  v.when(responsivity.has_value(), "responsivity", [&](Visitor& inner) {
    inner.number({"responsivity_at", "Temperature at which D was measured."}, d.reference, "K", range::positive);
    inner.number({"surface_at", "Temperature of the specimen."}, d.surface, "K", range::positive);
    measured(inner, {"amplification", "Amplification factor F of the signal."}, d.amplification);
    measured(inner, {"emissivity", "Emissivity of the specimen."}, d.emissivity, 1);
    std::vector<double> band{d.band.low, d.band.high};
    inner.numbers({"band", "Shortest and longest wavelength of the detector's band."}, band, "um", range::positive);
    const bool right = band.size() == 2 && band[1] > band[0];
    inner.require(right, {"band"}, "must be two wavelengths, the shorter one first, for example 3.6 um and 5.1 um");
    if (right) d.band = {band[0], band[1]};
  });
  if (!responsivity) return detector.reset();
  d.responsivity = *responsivity;
  detector = d;
}

}  // namespace

void declare(Visitor& v, StiffnessRequest& request) {
  v.number({"preload", "Only data above this force are used."}, request.curve.preload, "kN", range::not_negative);
  v.choice({"branch", "Part of a record's cycles that is fitted."}, request.curve.branch,
           {{"loading", ""}, {"unloading", ""}});
  v.number({"length", "Length of the cylinders, for the stiffness per unit length."}, request.length, "mm",
           range::positive);
}

void declare(Visitor& v, AdhesionRequest& request) {
  request.stiffness = measured(v, {"stiffness", "Contact stiffness of the pair; needed for the surface energy."},
                               request.stiffness, "kN/mm");
  std::vector<double> radii;
  if (request.radii) radii = {request.radii->first, request.radii->second};
  v.numbers({"radii", "Common radius of the cylinders, or the radius of each; needed for the surface energy."}, radii,
            "mm", range::positive);
  v.require(radii.size() <= 2, {"radii"}, "must be one radius, or two");
  if (!radii.empty()) request.radii = {radii.front(), radii.back()};
  const auto forms = elasticity::words(request.effective_radius);
  static const std::string sentence =
      "Effective radius of unequal radii: " + list_of(mapped(forms, &Word::sentence), ", ") + ".";
  v.choice({"effective_radius", sentence}, request.effective_radius, forms);
}

void declare(Visitor& v, FactorRequest& request) {
  v.number({"section", "Cross-section that carries the force, also as \"30.9 mm x 4.9 mm\"."}, request.section, "mm^2",
           range::positive);
  request.young = measured(v, {"young", "Modulus of the specimen, if the file gives strains."}, request.young, "GPa");
  request.poisson = measured(v, {"poisson", "Poisson's ratio of the specimen, if the file gives strains."},
                             request.poisson, "", 0.999999);
  recipe::declare(
      v,
      {"temperature_convention", "Whether temperatures and signals are peak-to-peak values or amplitudes of a sine.",
       false, "temperature_swing"},
      request.temperature);
  recipe::declare(v,
                  {"load_convention",
                   "Whether stresses, forces and strains are peak-to-peak values or amplitudes; force_max - "
                   "force_min is always peak to peak.",
                   false, "load_swing"},
                  request.load);
  v.flag({"through_origin", "The line is forced through the origin."}, request.through_origin);
  declare_detector(v, request.detector);
}

}  // namespace arenite::workflow
