#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "model/packing.hpp"

namespace arenite::texture {

/// Grains that carry nothing, 1 each: those with fewer than `least` of the contacts that count, found by taking them
/// away again and again, since a grain that leans on one of them alone is one too.
template <int D>
std::vector<std::uint8_t> loose_grains(const ContactsIn<D>& contacts, std::size_t grains, int least,
                                       const std::function<bool(std::size_t)>& counts);

}  // namespace arenite::texture
