#pragma once
#include <string>

#include "ledger/claim.hpp"
#include "ledger/results.hpp"
#include "ledger/sensitivity.hpp"

namespace arenite::ledger {

/// How a number of the sample of studies/thesis-choices with so many POM grains hangs on the choices that the thesis leaves open.
void add_choices(Judgement& judgement, const Results& results, const std::string& what, const std::string& pom_grains, const Number& number, const Wanted& wanted = {});
/// The same of the samples of chapter 4, 1000 grains, at the least and the greatest number ratio and between them.
void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const WantedAtEnds& wanted = {});
/// The same of studies/thesis-choices-stiffness, 1000 grains of chapter 5 at k_A/k_B = 10.
void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted = {});
/// The same of its slope against k_A/k_B, seed by seed.
void add_stiffness_slope(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted = {});
/// The same of studies/thesis-choices-glue, with glue and with next to none; something is wanted with glue only.
void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted = {});

/// k_A/k_B of a run of chapter 5.
double stiffness_ratio(const Run& run);
/// Mean overlap of contacts between grains over their mean diameter, a mean over runs.
double mean_overlap(const std::vector<Run>& runs);

}  // namespace arenite::ledger
