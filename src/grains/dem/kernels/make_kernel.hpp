#pragma once
#include "grains/dem/kernels/gear_loop.hpp"
#include "grains/dem/kernels/pair_loop.hpp"
#include "grains/dem/kernels/verlet_loop.hpp"

namespace arenite::dem {

/// All loops for W contacts or disks at a time; the laws in the order of their variants.
template <int W>
constexpr Kernel make_kernel(const char* name) {
  return {name,
          {{{pair_loop<W, Linear, NoAdhesion, RegularisedCoulomb>, pair_loop<W, Linear, NoAdhesion, CundallStrack>},
            {pair_loop<W, Linear, GeometricalAdhesion, RegularisedCoulomb>,
             pair_loop<W, Linear, GeometricalAdhesion, CundallStrack>}},
           {{pair_loop<W, Hertz, NoAdhesion, RegularisedCoulomb>, pair_loop<W, Hertz, NoAdhesion, CundallStrack>},
            {pair_loop<W, Hertz, GeometricalAdhesion, RegularisedCoulomb>,
             pair_loop<W, Hertz, GeometricalAdhesion, CundallStrack>}}},
          sweep<W, VerletBatch>,
          sweep<W, GearBatch>};
}
static_assert(std::variant_size_v<NormalChoice> == 2 && std::variant_size_v<AdhesionChoice> == 2 &&
              std::variant_size_v<FrictionChoice> == 2);

}  // namespace arenite::dem
