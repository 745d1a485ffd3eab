#pragma once
#include <string>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "model/packing.hpp"

namespace arenite::lammps {

/// What a stage asks for that LAMMPS cannot express, or cannot be asked back, each with the key and what helps; empty
/// where it can run it.
template <int D>
std::vector<std::string> inexpressible(const PackingIn<D>& start, const dem::ContactParameters& contact,
                                       const dem::IntegrationParameters& integration, const dem::Stage& stage);

/// The narrowest part of a container that LAMMPS shares out among so many processes, with the least surface between
/// them, m.
template <int D> double narrowest_part(const Container<D>& container, int processes);

}  // namespace arenite::lammps
