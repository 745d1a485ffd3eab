#include <fmt/core.h>

#include <cmath>
#include <tuple>

#include "validation/checks.hpp"
#include "validation/claims/claims.hpp"
#include "workflow/identify/identify_curves.hpp"

namespace arenite::validation {
namespace {

const identify::Finding* finding(const identify::Identification& all, const std::string& group,
                                 const std::string& name) {
  const auto in = [&](const identify::Group& one) -> const identify::Finding* {
    for (const auto& f : one.findings)
      if (f.name == name) return &f;
    return nullptr;
  };
  for (const auto& one : all.groups)
    if (one.name == group) return in(one);
  return all.all && group == "all" ? in(*all.all) : nullptr;
}

/// A mean of the records that must round to `printed`; half of its last digit is `half_digit`. A rounding is right or
/// wrong: the scatter of the records is reported and decides nothing.
Check rounds_to(std::string what, const identify::Finding* found, double printed, double half_digit) {
  Check check = within(std::move(what), found ? Value{found->value.value / found->scale(), 0} : Value(), printed,
                       half_digit, found ? found->unit : "");
  if (found)
    check.ours = {found->value.value / found->scale(), found->value.error / found->scale(), found->value.freedom};
  check.wanted = fmt::format("rounds to {:g}", printed);
  return check;
}

}  // namespace

/// Surface energies from the separation forces, k = 27.35 kN/mm and r_eff of two cylinders of 12.4 mm.
Judgement judge_t1(const Results& results) {
  Judgement judgement;
  const auto folder = results.study("thesis-ch2").folder();
  if (folder.empty()) return judgement;
  workflow::AdhesionRequest request;
  request.stiffness = statistics::Measured{27.35e6, statistics::unknown};
  request.radii = {6.2e-3, 6.2e-3};
  const auto found = workflow::identify_adhesion((folder / "separation-force.csv").string(), request);
  const std::pair<const char*, double> printed[] = {{"TOA adhesive latex", 0.268},
                                                    {"SADER colle bois", 0.511},
                                                    {"SADER fixer sans percer", 0.745},
                                                    {"PATTEX ni clou ni vis", 1.060}};
  for (const auto& [glue, gamma] : printed) {
    const auto* ours = finding(found, glue, "surface_energy");
    Check check = number(
        rounds_to(fmt::format("surface energy of {}", glue), ours, gamma, gamma < 1 ? 0.0005000001 : 0.005000001));
    check.wanted = fmt::format("{:g} to 3 significant digits", gamma);
    judgement.checks.push_back(check);
    judgement.checks.push_back(
        as(Kind::source,
           rounds_to(fmt::format("printed digits for {}, from the printed forces", glue), ours, gamma, 0.0005000001)));
    if (std::isfinite(check.ours.value))
      judgement.ours += fmt::format("{}{:.3f}", judgement.ours.empty() ? "" : ", ", check.ours.value);
  }
  if (!judgement.ours.empty()) judgement.ours += " kN/mm";
  judgement.decides =
      "The mean of the fourth glue's five separation forces gives 1.0608 kN/mm, which the thesis prints as 1.060; to "
      "three significant digits all four are reproduced.";
  judgement.findings.emplace_back(
      "These digits follow from r_eff = 12.4 mm, the diameter of two equal cylinders, for which 4 R*, r_i + r_j and 2 "
      "sqrt(r_i r_j) agree.");
  return judgement;
}

/// Means of the slopes of tables 2.1 and 2.2.
Judgement judge_t2(const Results& results) {
  Judgement judgement;
  const auto folder = results.study("thesis-ch2").folder();
  if (folder.empty()) return judgement;
  const auto pom = workflow::identify_stiffness((folder / "contact-stiffness-pom.csv").string(), {});
  const auto hdpe = workflow::identify_stiffness((folder / "contact-stiffness-hdpe.csv").string(), {});
  const auto* hdpe_mean = finding(hdpe, "all", "stiffness");
  if (!hdpe_mean && !hdpe.groups.empty()) hdpe_mean = finding(hdpe, hdpe.groups.front().name, "stiffness");
  const auto add = [&](Kind kind, const char* how, double d16, double d_all, double d_hdpe) {
    for (const auto& [what, found, printed] :
         {std::tuple{"k of POM, 16.4 mm", finding(pom, "D16.4mm", "stiffness"), d16},
          {"k of POM, all", finding(pom, "all", "stiffness"), d_all},
          {"k of HDPE", hdpe_mean, d_hdpe}})
      judgement.checks.push_back(as(kind, rounds_to(fmt::format("{}, {}", what, how), found, printed, 0.00501)));
  };
  add(Kind::source, "mean printed below its column", 25.45, 27.35, 6.43);
  add(Kind::number, "mean of the printed column", 25.63, 27.41, 6.42);
  if (const Check& all = judgement.checks[1]; std::isfinite(all.ours.value))
    judgement.ours = fmt::format("{} and {} kN/mm", text_of(all.ours), text_of(judgement.checks[2].ours));
  judgement.decides =
      "The thesis prints 25.45 below a column of table 2.1 whose mean is 25.63; its overall mean of 27.35 instead of "
      "27.41 follows from this error.";
  return judgement;
}

}  // namespace arenite::validation
