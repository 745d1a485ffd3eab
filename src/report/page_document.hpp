#pragma once
#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mapped.hpp"
#include "io/results/groups.hpp"
#include "report/figures/figure_document.hpp"
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

/// Places of the grains of each contact, "i" and "j"; walls are numbered after the grains by their side.
Numbers pairs_of(const Packing& packing, NumberBlock& block);
/// Every column by its name, at most about a thousand rows of it.
Numbers history_of(const History& history, NumberBlock& block);
Numbers provenance_of(const Provenance& provenance);
/// Adds "numbers", shortened, and their "meanings": from these the page names all that it shows of them.
void add_numbers(Numbers& out, const Numbers& numbers);
/// With six significant digits: more than a figure or a standard error can use, and a third of the bytes. A tree where
/// nothing is known.
Numbers shortened(Numbers numbers);

/// Which nodes of a large map the page draws: every `stride`-th in both directions, from the middle of the first block.
/// A map of up to about a million nodes is drawn whole.
struct Thinning {
  int stride = 1;
  int width = 0, height = 0;      ///< nodes that are left
  std::vector<std::size_t> node;  ///< their indices in the map

  explicit Thinning(const PhaseMap& map, std::size_t most = 1'200'000);

  template <class T> std::vector<T> of(const std::vector<T>& values) const {
    if (stride == 1) return values;
    return mapped(node, [&](std::size_t at) { return values[at]; });
  }
};

/// What a run measured of the part at this place of a list of results; nothing where it did not.
template <class Part>
const Part* known_of(const workflow::KnownStatistics* measured,
                     std::vector<std::optional<Part>> workflow::KnownStatistics::*parts, std::size_t at) {
  return measured && at < (measured->*parts).size() && (measured->*parts)[at] ? &*(measured->*parts)[at] : nullptr;
}

/// Adds "maps" (every phase map once) and "fields" (one a result) to the page's document. Densities of stresses that
/// are not known are measured as those in the result's numbers were; all components are shown, whichever these name.
void add_fields(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write);
/// Those densities of a field, as stress::numbers gives them.
Numbers densities_of(const FieldResult& result);

/// Adds a film to "films" of the page's document: maps, grains in pixels, contacts and, where there are any, the
/// stresses of grains beside those of the companion simulation. `texture` is the film's (workflow::texture_of), if it
/// has grains.
void add_film(Numbers& document, const FilmResult& film, const texture::Texture* texture, NumberBlock& block,
              const figures::WriteList& write);

// What the page shows of packings.

Numbers materials_of(const Materials& materials);
/// What is the same of all states: names, radii, materials, zones and shapes of the grains.
Numbers grains_of(const Grains& grains, NumberBlock& block);

/// One state: its container, grains, contacts, bonds and pulls, and its texture, where that is known, with what else
/// is.
Numbers snapshot_of(const Snapshot& snapshot, std::size_t stage, const texture::Texture* texture,
                    const Numbers& also_known, NumberBlock& block);

/// The coarse-grained fields of a state on a grid over its box: {bounds, columns, rows, width of the kernel} and arrays
/// of solid fraction, density, velocity, pressure and deviator of the whole stress, its shear and the kinetic pressure.
/// The kernel is as wide as the mean grain, or as a cell where the sample has many. `shear_rate`, 1/s: of a cell that
/// is sheared. Not known without grains or box.
Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block);

}  // namespace arenite::report
