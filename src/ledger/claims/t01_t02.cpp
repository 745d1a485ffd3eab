#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/trends.hpp"
#include "study/identify.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* no_sample = "It is worked out from the laboratory's records: no friction, damping or seed enters.";

const identify::Finding* finding(const identify::Identification& all, const std::string& group, const std::string& name) {
  const auto in = [&](const identify::Group& one) -> const identify::Finding* {
    for (const auto& f : one.findings)
      if (f.name == name) return &f;
    return nullptr;
  };
  for (const auto& one : all.groups)
    if (one.name == group) return in(one);
  return all.all && group == "all" ? in(*all.all) : nullptr;
}

/// A mean that must round to `printed`; half of its last digit is `half_digit`.
Check rounds_to(std::string what, const identify::Finding* found, double printed, double half_digit) {
  const Value ours = found ? Value(found->value.value / found->scale, found->value.error / found->scale) : Value();
  Check check = within(std::move(what), ours, printed, half_digit, found ? found->unit : "");
  check.tolerance = fmt::format("rounds to {:g}", printed);
  return check;
}

}  // namespace

/// Surface energies from the separation forces, k = 27.35 kN/mm and r_eff of two cylinders of 12.4 mm.
Judgement judge_t1(const Results& results) {
  Judgement judgement;
  const auto folder = results.study("thesis-ch2").folder();
  if (folder.empty()) return judgement;
  study::AdhesionRequest request;
  request.stiffness = statistics::Measured{27.35e6, statistics::unknown};
  request.radii = {6.2e-3, 6.2e-3};
  const auto found = study::identify_adhesion((folder / "separation-force.csv").string(), request);
  const std::pair<const char*, double> printed[] = {
      {"TOA adhesive latex", 0.268}, {"SADER colle bois", 0.511}, {"SADER fixer sans percer", 0.745}, {"PATTEX ni clou ni vis", 1.060}};
  for (const auto& [glue, gamma] : printed) {
    const auto* ours = finding(found, glue, "surface_energy");
    const std::string what = fmt::format("surface energy of {}", glue);
    judgement.stated.checks.push_back(rounds_to(what, ours, gamma, 0.0005000001));
    judgement.sharpened.checks.push_back(rounds_to(what, ours, gamma, gamma < 1 ? 0.0005000001 : 0.005000001));
    judgement.sharpened.checks.back().tolerance = "to 3 significant digits";
  }
  judgement.findings.emplace_back("r_eff = 12.4 mm for two equal cylinders of that diameter is what gives these digits; 4 R*, r_i + r_j and 2 sqrt(r_i r_j) agree there.");
  judgement.findings.emplace_back("The mean of the fourth glue's five separation forces gives 1.0608 kN/mm, which the thesis prints as 1.060.");
  judgement.findings.emplace_back(no_sample);
  return judgement;
}

/// Means of the slopes of tables 2.1 and 2.2.
Judgement judge_t2(const Results& results) {
  Judgement judgement;
  const auto folder = results.study("thesis-ch2").folder();
  if (folder.empty()) return judgement;
  const auto pom = study::identify_stiffness((folder / "contact-stiffness-pom.csv").string(), {});
  const auto hdpe = study::identify_stiffness((folder / "contact-stiffness-hdpe.csv").string(), {});
  const auto* hdpe_mean = finding(hdpe, "all", "stiffness");
  if (!hdpe_mean && !hdpe.groups.empty()) hdpe_mean = finding(hdpe, hdpe.groups.front().name, "stiffness");
  const auto add = [&](Verdict& verdict, double d16, double d_all, double d_hdpe) {
    verdict.checks.push_back(rounds_to("k of POM, 16.4 mm", finding(pom, "D16.4mm", "stiffness"), d16, 0.00501));
    verdict.checks.push_back(rounds_to("k of POM, all", finding(pom, "all", "stiffness"), d_all, 0.00501));
    verdict.checks.push_back(rounds_to("k of HDPE", hdpe_mean, d_hdpe, 0.00501));
  };
  add(judgement.stated, 25.45, 27.35, 6.43);
  add(judgement.sharpened, 25.63, 27.41, 6.42);
  judgement.findings.emplace_back("The thesis prints 25.45 below a column whose mean is 25.63; its overall mean follows from that slip.");
  judgement.findings.emplace_back(no_sample);
  return judgement;
}

}  // namespace arenite::ledger
