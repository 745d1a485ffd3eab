#pragma once

/// Finite elements on the pixels of a phase map: one square element a pixel, unknowns at its corners.
namespace arenite::elements {

/// How an element bends.
enum class Element {
  wilson,  ///< bilinear with E. L. Wilson's incompatible modes (1973), condensed: pure bending is exact
  full     ///< bilinear, fully integrated: the usual element, too stiff in bending by 1/n^2 for n of them across
};

/// What happens across the plane: nothing pulls (a thin plate), or nothing strains (a long prism).
enum class PlaneState { stress, strain };

/// Elastic constants of one kind of pixel.
struct Constants {
  double young = 1;  ///< Pa
  double poisson = 1.0 / 3;
};

/// What pixels are made of. A pixel of interface is one of a grain that has one of another grain beside it or across a
/// corner, or one of matrix that has one of a grain there: what in a lattice would be bonds between the two.
struct Material {
  Constants matrix{1}, interface { 1 }, particle{4};
  Element element = Element::wilson;
  PlaneState plane = PlaneState::stress;
};

}  // namespace arenite::elements
