#pragma once
#include <vector>

#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// What a contact remembers, keyed by the grains (or grain and wall) that it joins. A periodic cell is at least two
/// reaches wide, so no pair meets twice.
struct Carried {
  std::uint64_t key;
  double memory;
  std::uint8_t bond;
};

/// Gives the listed contacts what they remember; `all` is sorted by key.
void carry_into(Sample& sample, const std::vector<Carried>& all);

/// Takes over what touching pairs remember from the list before a rebuild; disk k was number `was[k]` in it.
void carry_over(Sample& sample, const ContactList& before, const std::vector<std::int32_t>& was, const Team& team);

}  // namespace arenite::dem
