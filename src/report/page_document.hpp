#pragma once
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/results/groups.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"
#include "workflow/run.hpp"

namespace arenite::report {

/// The data of a page: a JSON text in which arrays of numbers by grain or contact are {"at": byte, "n": count, "as":
/// type, "unit"} into the block `numbers` (NumberBlock::text), and what statistics measured has unit and sentence
/// beside it (`add_numbers`).
struct PageDocument {
  std::string json;
  std::string numbers;
};

PageDocument page_document(const PageData& data);

// Pieces that packings, fields and films write alike.

/// Those of an owner's declared columns that have these names, with their units, as `add` writes them; a column without
/// values is left out.
template <class Owner, std::size_t N>
void add_columns(Numbers& out, const Owner& owner, const io::Column<Owner> (&declared)[N],
                 std::initializer_list<std::string_view> names, NumberBlock& block,
                 NumberRef (NumberBlock::*add)(std::span<const double>, std::string) = &NumberBlock::add_reals) {
  for (const io::Column<Owner>& column : declared)
    if (std::ranges::count(names, std::string_view(column.name)) > 0)
      if (const auto values = column.of(owner); !values.empty()) out[column.name] = (block.*add)(values, column.unit);
}

/// Every column by its name, at most about a thousand rows of it.
Numbers history_of(const History& history, NumberBlock& block);
Numbers provenance_of(const Provenance& provenance);
/// Adds "numbers", shortened, and their "meanings": from these the page names all that it shows of them; and
/// "elsewhere", the names of those that it tells otherwise than in a table.
void add_numbers(Numbers& out, const Numbers& numbers);
/// With six significant digits: more than a figure or a standard error can use, and a third of the bytes. A tree where
/// nothing is known.
Numbers shortened(Numbers numbers);

/// What a run measured of the part at this place of a list of results; nothing where it did not.
template <class Part>
const Part* known_of(const workflow::KnownStatistics* measured,
                     std::vector<std::optional<Part>> workflow::KnownStatistics::*parts, std::size_t at) {
  return measured && at < (measured->*parts).size() && (measured->*parts)[at] ? &*(measured->*parts)[at] : nullptr;
}

/// What is said of what grains and coarse-grained fields are drawn by: {name: [label, symbol, unit, formula, scale of
/// colours]}.
template <class Kinds> Numbers named_kinds(const Kinds& kinds) {
  Numbers out = Numbers::tree();
  for (const auto& kind : kinds)
    out[kind.name] = Numbers::list({kind.label, kind.symbol, kind.unit, kind.formula, word_of(kind.colours)});
  return out;
}

}  // namespace arenite::report
