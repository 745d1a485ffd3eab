#pragma once
#include <string>

#include "ledger/claim.hpp"
#include "ledger/results.hpp"

namespace arenite::ledger {

/// Adds a sentence: a number of the sample of studies/thesis-choices with so many POM grains, with each choice that the thesis
/// leaves open made otherwise. Nothing where there are no runs.
void add_choices(Judgement& judgement, const Results& results, const std::string& what, const std::string& pom_grains, const Number& number);
/// The same of the samples of chapter 4, 1000 grains, at the least and the greatest number ratio.
void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number);
/// The same of studies/thesis-choices-stiffness, 1000 grains of chapter 5 at k_A/k_B = 10.
void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number);
/// The same of studies/thesis-choices-glue, with glue and with next to none.
void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number);

/// Mean overlap of contacts between grains over their mean diameter, a mean over runs.
double mean_overlap(const std::vector<Run>& runs);

}  // namespace arenite::ledger
