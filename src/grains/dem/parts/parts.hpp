#pragma once
#include <tuple>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "grains/dem/parts/bonds.hpp"
#include "grains/dem/parts/cohesion.hpp"
#include "grains/dem/parts/energy_balance.hpp"
#include "grains/dem/parts/loading.hpp"
#include "grains/dem/parts/rough_walls.hpp"
#include "grains/dem/parts/spheres_alone.hpp"

namespace arenite::dem {

/// The parts that a sample of each dimension has, in the order in which they are called. The one place that knows.
template <int D> struct PartsOf;
template <> struct PartsOf<2> {
  using type = std::tuple<RoughWalls, Bodies, CohesivePairs, Bonds, Membranes, Boundaries, LoadingIn<2>, EnergyBalance>;
};
template <> struct PartsOf<3> {
  using type = std::tuple<RoughWallsIn<3>, SpheresAlone, CohesivePairsIn<3>, BondsIn<3>, BoundariesIn<3>, LoadingIn<3>,
                          EnergyBalanceIn<3>>;
};

template <int D, class... P> consteval bool are_parts(const std::tuple<P...>* /*of*/) { return (Part<P, D> && ...); }
static_assert(are_parts<2>(static_cast<PartsOf<2>::type*>(nullptr)));
static_assert(are_parts<3>(static_cast<PartsOf<3>::type*>(nullptr)));

}  // namespace arenite::dem
