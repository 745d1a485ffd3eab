#pragma once
#include <string>

#include "validation/claim.hpp"
#include "validation/claims/chapter3.hpp"
#include "validation/results.hpp"
#include "validation/sensitivity.hpp"

namespace arenite::validation {

// How a number depends on the choices that the thesis leaves open. As it is: the runs that the claim is judged by;
// otherwise those of the studies thesis-choices of the chapter, and for another border the same states measured again.

/// Of a sample of chapter 3.
void add_choices(Judgement& judgement, const Results& results, const std::string& what, const LaboratorySample& sample,
                 const Number& number, const Wanted& wanted = {});
/// Of chapter 4 at the least and the greatest number ratio and between them.
void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                           const WantedAtEnds& wanted = {});
/// Of chapter 5 at k_A/k_B = 10.
void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                           const Wanted& wanted = {});
/// Of its change with k_A/k_B, worked out from all runs of a choice.
void add_stiffness_change(Judgement& judgement, const Results& results, const std::string& what,
                          Value (*change)(const std::vector<Run>&, const Number&), const Number& number,
                          const Wanted& wanted);
/// Of chapter 6, with glue and with next to none; something is wanted with glue only.
void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                      const Wanted& wanted = {});

/// Of its change by glue, seed by seed in the same packings.
void add_change_by_glue(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                        const Wanted& wanted);

/// Adds what the tables need of the states with other borders.
void measure_with_other_borders(Results& results);

/// k_A/k_B of a run of chapter 5.
double stiffness_ratio(const Run& run);
/// Mean overlap of contacts between grains over their mean diameter, a mean over runs.
double mean_overlap(const std::vector<Run>& runs);

}  // namespace arenite::validation
