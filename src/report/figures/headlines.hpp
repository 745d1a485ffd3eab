#pragma once
#include "grains/fields/laboratory/test_kind.hpp"
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// A number that one asks for first: its words, its symbol, its dotted name, and "%" where a share is said in per cent.
struct Headline {
  const char *words, *symbol, *name, *share = "";
};
/// Of a kind of test, the most telling first; empty where it is none.
std::vector<Headline> headlines_of(fields::TestKind kind);

/// What the page has of a stage's test: its kind, what it gave beyond the texture of its states, and which of it one
/// asks for first; of a sample that failed also the shown state nearest to its strength, with which the page opens.
void add_test(Numbers& shown, const StageData& data);

}  // namespace arenite::report::figures
