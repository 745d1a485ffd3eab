#pragma once

namespace arenite::geometry {

/// Two disks and the liquid between them in the plane: on either side of the joining line a circular arc that is hollow
/// towards the gas and meets both rims at the contact angle, measured in the liquid. At contact angle 0 it is the
/// meniscus of meniscus.hpp. Disks that overlap are no case of it.
struct LiquidBridge {
  double radius_i = 0, radius_j = 0;  ///< m
  double contact_angle = 0;           ///< rad, 0 to below pi/2
};

/// A bridge across a gap with arcs of one radius. Per length of the cylinders and surface tension: `energy` is that of
/// the surfaces, the liquid's less cos(contact angle) times the wetted one, `pull` = d energy/d gap at constant area
/// (its tension and the lower pressure in it, Laplace's), and `slope` d pull/d gap at constant area.
struct BridgeState {
  double area = 0;                         ///< of the liquid on both sides of the joining line, m^2
  double neck = 0;                         ///< half the width of the liquid where the arcs are nearest to each other, m
  double energy = 0, pull = 0, slope = 0;  ///< m, 1, 1/m
};
BridgeState bridge_state(const LiquidBridge& bridge, double gap, double arc_radius);

/// Radius of the arcs that meet in one point between disks with a gap > 0, m: a bridge of less radius, or of less area,
/// cannot span it.
double thinnest_arc(const LiquidBridge& bridge, double gap);

/// Radius of the arcs that enclose this area across a gap, m. The area must be at least that of the thinnest bridge and
/// less than that of straight surfaces.
double arc_radius(const LiquidBridge& bridge, double gap, double area);

/// The gap at which a bridge of this area has drawn itself out to nothing in its middle, m.
double rupture_gap(const LiquidBridge& bridge, double area);

/// Area that straight surfaces enclose between touching disks, m^2: with more liquid they bulge.
double straight_bridge_area(const LiquidBridge& bridge);

}  // namespace arenite::geometry
