#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mapped.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// The data of a page: a JSON text in which arrays of numbers by grain or contact are {"at": byte, "n": count, "as": type}
/// into the block `numbers` (NumberBlock::text).
struct PageDocument {
  std::string json;
  std::string numbers;
};

PageDocument page_document(const PageData& data);

// Pieces that packings, fields and films write alike.

template <class T> std::vector<std::uint32_t> unsigned_copy(const std::vector<T>& values) {
  return mapped(values, [](T value) { return static_cast<std::uint32_t>(value); });
}

/// Places of the grains of each contact, "i" and "j"; walls are numbered after the grains by their side.
Numbers pairs_of(const Packing& packing, NumberBlock& block);
/// How far a state is from rest; `speed` names that of its walls.
Numbers rest_of(const Equilibrium& now, const char* speed);
/// Every column with its unit, at most about a thousand rows of it.
Numbers history_of(const History& history, NumberBlock& block);
Numbers provenance_of(const Provenance& provenance);
/// Unit and sentence of each number that a statistic declares, by its dotted name: {"solid_fraction": ["", "Area of grains over ..."]}.
Numbers meanings_of(const Numbers& numbers);
/// With six significant digits: more than a figure or a standard error can use, and a third of the bytes. A tree where nothing is known.
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

/// Adds "maps" (every phase map once) and "fields" (one a result) to the page's document. Densities of stresses are measured as those in the result's
/// numbers were; all components are shown, whichever these name.
void add_fields(Numbers& document, std::span<const FieldResult> fields, NumberBlock& block);

/// Adds "films" (one a result) to the page's document: maps, grains in pixels, contacts and, where there are any, the
/// statistics of grain stresses and what relates them to the companion simulation's.
void add_films(Numbers& document, std::span<const FilmResult> films, NumberBlock& block);

// What the page shows of a packing beside its grains and contacts.

/// The coarse-grained fields of a state on a grid over its box: {bounds, columns, rows, width of the kernel} and arrays of solid fraction,
/// density, velocity, pressure and deviator of the whole stress, its shear and the kinetic pressure. The kernel is as wide as the mean grain,
/// or as a cell where the sample has many. `shear_rate`, 1/s: of a cell that is sheared. Not known without grains or box.
Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block);

/// Rims of grains that are no disks, from their centres where their angles are 0: those of grain g are points first[g] to first[g + 1] - 1.
Numbers shapes_of(Grains grains, NumberBlock& block);

/// What the page knows of every grain in a state: pressure p = -sigma_hyd and deviator q of its stress, Pa (half the sum and half the difference
/// of the principal ones), its velocity and its spin. Of a state at rest the last two are left out.
void add_grain_values(Numbers& out, const Packing& packing, NumberBlock& block);

/// Bonds that hold, and how the others broke.
Numbers bonds_of(const Packing& packing, NumberBlock& block);

/// Pairs that a pull joins, touching or not.
Numbers cohesive_of(const Packing& packing, NumberBlock& block);

Numbers boundaries_of(const Domain& domain, NumberBlock& block);

/// Asked and measured size curve of the grains that the recipe asked a size law for; not known where it asked for none.
Numbers size_curves_of(const Packing& packing, const std::string& recipe, NumberBlock& block);

}  // namespace arenite::report
