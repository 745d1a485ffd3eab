#pragma once
#include "core/lanes.hpp"

namespace arenite::voxels {

/// The eight modes of a component of displacement on a voxel, by the axes along which they change sign: bit 0 for x, 1
/// for y, 2 for z. An amplitude is the sum of the corners' values with these signs: that of x is four times the mean
/// gradient along x times the side. Mode 0, a translation, has no energy.
enum Mode { mode_x = 1, mode_y = 2, mode_xy = 3, mode_z = 4, mode_zx = 5, mode_yz = 6, mode_xyz = 7, modes_of_a_voxel };

/// The stiffness of a voxel of unit side in modes, Pa: C_11, C_12 and C_66 over 16 for uniform strain; for gradients
/// that are linear in one coordinate `along` acts on a component that stretches and `across` between two of them; the
/// trilinear mode has one number.
template <class C> struct ModesOf { C axial{}, cross{}, shear{}, along{}, across{}, trilinear{}; };
using Modes = ModesOf<double>;

/// Amplitudes of the displacement, or what the energy changes by with them: [component][mode].
template <class N> struct Amplitudes { N at[3][modes_of_a_voxel]; };

ARENITE_INLINE double multiply_add(double a, double b, double c) { return a * b + c; }
template <class T, int n> ARENITE_INLINE Lanes<T, n> multiply_add(Lanes<T, n> a, Lanes<T, n> b, Lanes<T, n> c) {
  return fma(a, b, c);
}

/// What the energy of a voxel changes by with each amplitude: the energy is half the sum of the products.
template <class C, class N> ARENITE_INLINE Amplitudes<N> work_of(const ModesOf<C>& m, const Amplitudes<N>& a) {
  const auto &u = a.at[0], &v = a.at[1], &w = a.at[2];
  Amplitudes<N> p{};
  p.at[0][mode_x] = multiply_add(m.axial, u[mode_x], m.cross * (v[mode_y] + w[mode_z]));
  p.at[1][mode_y] = multiply_add(m.axial, v[mode_y], m.cross * (w[mode_z] + u[mode_x]));
  p.at[2][mode_z] = multiply_add(m.axial, w[mode_z], m.cross * (u[mode_x] + v[mode_y]));
  p.at[0][mode_y] = p.at[1][mode_x] = m.shear * (u[mode_y] + v[mode_x]);
  p.at[1][mode_z] = p.at[2][mode_y] = m.shear * (v[mode_z] + w[mode_y]);
  p.at[2][mode_x] = p.at[0][mode_z] = m.shear * (w[mode_x] + u[mode_z]);
  p.at[0][mode_xy] = multiply_add(m.along, u[mode_xy], m.across * w[mode_yz]);
  p.at[2][mode_yz] = multiply_add(m.along, w[mode_yz], m.across * u[mode_xy]);
  p.at[1][mode_xy] = multiply_add(m.along, v[mode_xy], m.across * w[mode_zx]);
  p.at[2][mode_zx] = multiply_add(m.along, w[mode_zx], m.across * v[mode_xy]);
  p.at[1][mode_yz] = multiply_add(m.along, v[mode_yz], m.across * u[mode_zx]);
  p.at[0][mode_zx] = multiply_add(m.along, u[mode_zx], m.across * v[mode_yz]);
  const C third = m.shear * C(1.0 / 3);
  const N turning = u[mode_yz] + v[mode_zx] + w[mode_xy];
  p.at[0][mode_yz] = third * (u[mode_yz] + turning);
  p.at[1][mode_zx] = third * (v[mode_zx] + turning);
  p.at[2][mode_xy] = third * (w[mode_xy] + turning);
  for (int c = 0; c < 3; ++c) p.at[c][mode_xyz] = m.trilinear * a.at[c][mode_xyz];
  return p;
}

}  // namespace arenite::voxels
