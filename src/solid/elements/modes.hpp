#pragma once
#include <array>

#include "core/lanes.hpp"
#include "solid/elements/options.hpp"

namespace arenite::elements {

/// The modes of a component of displacement on an element, by the axes along which they change sign: bit 0 for x, 1 for
/// y, 2 for z. An amplitude is the sum of the corners' values with these signs: that of x is the mean gradient along x
/// times the side and half the number of corners. Mode 0, a translation, has no energy.
enum Mode { mode_x = 1, mode_y = 2, mode_xy = 3, mode_z = 4, mode_zx = 5, mode_yz = 6, mode_xyz = 7 };
template <int D> inline constexpr int mode_count = 1 << D;

/// The stiffness of an element of unit side in modes, Pa: C_11, C_12 and C_66 over the square of half the number of
/// corners for uniform strain, and what gradients that are linear in another coordinate ask. In the plane that is
/// bending, a twelfth of C_11 + C_66 (full) or C_11 - C_12^2/C_11 (Wilson). In space `along` acts on a component that
/// stretches and `across` between two of them; the trilinear mode has one number.
template <int D, class C> struct ModesOf;
template <class C> struct ModesOf<2, C> {
  C axial{}, cross{}, shear{}, bending{};
  static constexpr std::array<C ModesOf::*, 4> members{&ModesOf::axial, &ModesOf::cross, &ModesOf::shear,
                                                       &ModesOf::bending};
};
template <class C> struct ModesOf<3, C> {
  C axial{}, cross{}, shear{}, along{}, across{}, trilinear{};
  static constexpr std::array<C ModesOf::*, 6> members{&ModesOf::axial, &ModesOf::cross,  &ModesOf::shear,
                                                       &ModesOf::along, &ModesOf::across, &ModesOf::trilinear};
};
template <int D> using Modes = ModesOf<D, double>;

/// Of a material; the state of the plane means nothing in space.
template <int D> Modes<D> modes_of(const Constants& constants, Element element, PlaneState plane);
template <> Modes<2> modes_of<2>(const Constants& constants, Element element, PlaneState plane);
template <> Modes<3> modes_of<3>(const Constants& constants, Element element, PlaneState plane);

/// Amplitudes of the displacement, or what the energy changes by with them: [component][mode].
template <int D, class N> struct Amplitudes { N at[D][mode_count<D>]; };

ARENITE_INLINE double multiply_add(double a, double b, double c) { return a * b + c; }
template <class T, int n> ARENITE_INLINE Lanes<T, n> multiply_add(Lanes<T, n> a, Lanes<T, n> b, Lanes<T, n> c) {
  return fma(a, b, c);
}

/// What the energy of an element changes by with each amplitude: the energy is half the sum of the products.
template <class C, class N> ARENITE_INLINE Amplitudes<2, N> work_of(const ModesOf<2, C>& m, const Amplitudes<2, N>& a) {
  const auto &u = a.at[0], &v = a.at[1];
  Amplitudes<2, N> p;
  p.at[0][0] = p.at[1][0] = N{};
  p.at[0][mode_x] = multiply_add(m.axial, u[mode_x], m.cross * v[mode_y]);
  p.at[1][mode_y] = multiply_add(m.axial, v[mode_y], m.cross * u[mode_x]);
  p.at[0][mode_y] = p.at[1][mode_x] = m.shear * (u[mode_y] + v[mode_x]);
  p.at[0][mode_xy] = m.bending * u[mode_xy];
  p.at[1][mode_xy] = m.bending * v[mode_xy];
  return p;
}
template <class C, class N> ARENITE_INLINE Amplitudes<3, N> work_of(const ModesOf<3, C>& m, const Amplitudes<3, N>& a) {
  const auto &u = a.at[0], &v = a.at[1], &w = a.at[2];
  Amplitudes<3, N> p;
  p.at[0][0] = p.at[1][0] = p.at[2][0] = N{};
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

/// The sign that a corner's value has in a mode.
ARENITE_INLINE constexpr int sign_of(int mode, int corner) {
  return __builtin_parity(static_cast<unsigned>(mode & ~corner)) ? -1 : 1;
}

/// The stiffness between corners c and d of an element of unit side, [component of c][component of d], Pa.
template <int D> std::array<std::array<double, D>, D> corner_block(const Modes<D>& modes, int c, int d);
/// The largest eigenvalue of D_e^-1 K_e of one kind, D_e the blocks of its corners.
template <int D> double highest_ratio(const Modes<D>& modes);

}  // namespace arenite::elements
