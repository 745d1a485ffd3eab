#pragma once
#include "thermal/camera/camera.hpp"

#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/camera/virtual_film.hpp"

namespace arenite::camera {

/// One disk between two references, pressed by P, its centre at (x, 0); the frame is far away.
inline Packing pressed_disk(double force, double x = 0) {
  Packing packing;
  packing.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}};
  packing.domain.thickness = 0.06;
  const double far[4] = {-0.2, 0.2, -0.2, 0.2};
  for (int side = 0; side < 4; ++side) packing.domain.wall[side].position = far[side];
  packing.grains.resize(1);
  packing.grains.position[0].x = x;
  packing.grains.radius[0] = 0.0155;
  packing.contacts.add(0, wall_partner(bottom), {0, 1}, force, 0, 0.0155, 0);
  packing.contacts.add(0, wall_partner(top), {0, -1}, force, 0, 0.0155, 0);
  return packing;
}

/// A camera without any fault, 64 x 64 pixels of 1.6 mm.
inline Parameters ideal() {
  Parameters p;
  p.optics.width = p.optics.height = 64;
  p.optics.blur = 0;
  p.detector.netd = p.detector.gain_spread = p.detector.offset_spread = p.detector.bad_share = 0;
  p.surroundings.drift = 0;
  p.surroundings.emissivity = {1};
  p.timing = {148, 148, 0, 1, 0, 0, 0};
  p.motion = false;
  return p;
}

}  // namespace arenite::camera
