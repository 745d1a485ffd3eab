#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "grains/fields/laboratory/test_kind.hpp"
#include "model/film_result.hpp"
#include "model/result.hpp"
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// A number that one asks for first: its words, its symbol, its dotted name, and "%" or "\u2030" where a share is said
/// in per cent or per mille. One that no statistic declares has no name, and is written as it is, with what stands
/// behind it.
struct Headline {
  const char *words, *symbol, *name, *share = "";
  std::string said = {}, behind = {};
};
/// Of a kind of test, the most telling first; empty where it is none.
std::vector<Headline> headlines_of(fields::TestKind kind);

/// Of the grains of a packing on which this test was made.
std::vector<Headline> headlines_of_grains(fields::TestKind kind);

/// Of a sample on a grid always, with its response where it was loaded; those that are known, three of each.
std::vector<Headline> headlines_of(const FieldResult& field);
/// Of a sample in space.
std::vector<Headline> headlines_of(const VoxelResult& sample);
/// Of a sample of spheres.
std::vector<Headline> headlines_of(const SphereResult& sample);
/// Of a film: six, or three where fewer are known.
std::vector<Headline> headlines_of(const FilmResult& film);

/// What `arenite show` prints first, as rows_of takes it: all that tests tell, then of grains, nodes and voxels, with
/// every headline among it.
std::string first_rows(const Numbers& numbers);

/// Numbers that the figures of a study show first, parted by blanks: beside the headlines of its kind of test, or of a
/// study of no test.
std::string_view first_of_studies(bool of_a_test);

/// Whether a headline says what was asked for, not what came of it.
bool is_asked_for(std::string_view name);

/// [words, symbol, name, share] of each, or {words, value, unit} of what is written as it is.
Numbers numbers_of(const std::vector<Headline>& list);

/// What the page has of a stage's test: its kind, what it gave beyond the texture of its states, and which of it and of
/// the grains one asks for first; of a sample that failed also the shown state nearest to its strength, with which the
/// page opens.
void add_test(Numbers& shown, const StageData& data);

}  // namespace arenite::report::figures
