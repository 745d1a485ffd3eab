#pragma once
#include <string>

#include "model/packing.hpp"

namespace arenite::texture {

/// That a side was taken away, or never stood there, and what is told of the box nevertheless; empty where all stand.
template <int D> std::string note_of_sides_away(const DomainIn<D>& domain);

}  // namespace arenite::texture
