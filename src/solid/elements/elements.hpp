#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pages.hpp"
#include "model/phase_map.hpp"
#include "solid/elements/options.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::elements {

using statics::Aggregates;
using statics::Block;
using statics::BlockDiagonal;
using statics::Field;
using statics::Grid;

/// Kind of a pixel.
enum Kind : std::uint32_t { none = 0, matrix = 1, interface = 2, particle = 3 };

/// The stiffness of an element in modes. With the corners' values u00, u10, u01, u11 (first index along x) the
/// amplitudes of a component are gx = u10 + u11 - u00 - u01, gy = u01 + u11 - u00 - u10, h = u00 + u11 - u10 - u01:
/// twice the mean gradient times dx, and the bending. The energy of an element, J/m, is half of
///   axial (gx_u^2 + gy_v^2) + 2 cross gx_u gy_v + shear (gy_u + gx_v)^2 + bending (h_u^2 + h_v^2),
/// with axial, cross and shear a quarter of the elastic constants C_11, C_12 and C_66, and bending a twelfth of
/// C_11 + C_66 (full) or C_11 - C_12^2/C_11 (Wilson), all in Pa.
struct Modes {
  double axial = 0, cross = 0, shear = 0, bending = 0;
};
Modes modes_of(const Constants& constants, Element element, PlaneState plane);

/// A phase map as elements. Nodes are the corners of the pixels, one more each way than there are pixels; the pixel
/// whose lower left corner is node i has its kind at words[i], in bits 0 and 1.
struct Elements {
  static constexpr int dimension = 2;
  static constexpr bool rests_when_strained = true;
  Grid grid;                                    ///< of corners
  Buffer<std::uint32_t> words;                  ///< padded
  std::array<Modes, 4> modes;                   ///< by kind, as the kernels have them: rounded to single precision
  std::array<std::array<float, 4>, 4> table{};  ///< axial, cross, shear and bending by kind

  Kind kind(std::ptrdiff_t i) const { return static_cast<Kind>(words[i] & 3u); }
  int columns() const { return grid.width - 1; }  ///< of pixels
  int rows() const { return grid.height - 1; }
};

/// Throws InputError for a modulus that is not positive or a Poisson's ratio outside (-1, 1/2).
Elements make_elements(const PhaseMap& map, const Material& material);

// What the static solver asks (statics/discretisation.hpp), beside couplings and kernels_of (kernels/kernels.hpp).

BlockDiagonal<double> block_diagonal(const Elements& elements);
/// Up to the largest eigenvalue of D_e^-1 K_e over the kinds, which no sum of elements exceeds. Elements reach less far
/// than bonds, so that the coarse space leaves the smoother longer waves.
statics::Smoothing smoothing_of(const Elements& elements);

/// A corner belongs to the grain that most of the stiffness of its four pixels is of, matrix flooded to grains; pieces
/// hang together by elements. `prescribed` has one entry a row of corners.
Aggregates cut_into_aggregates(const PhaseMap& map, const Elements& elements,
                               const std::vector<std::uint8_t>& prescribed);

/// Displacement and stress in the middle of every pixel of the map; zero in the void. The stress there is the mean of
/// the element's.
StressField pixel_stress(const PhaseMap& map, const Elements& elements, const Field<double>& u);

}  // namespace arenite::elements
