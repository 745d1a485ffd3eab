const degree = Math.PI / 180;

export const axes = ["x", "y", "z"];

/** The picture's directions in space: to its right, upwards, and towards the viewer, who stands at an azimuth about the
    upright axis (2: z, counted from x; 1: y, counted from z) and at an elevation (degrees). */
export function frameOf(azimuth, elevation, upright = 2) {
  const [ca, sa] = [Math.cos(azimuth * degree), Math.sin(azimuth * degree)],
    [ce, se] = [Math.cos(elevation * degree), Math.sin(elevation * degree)];
  const direction = (...parts) => axes.map((_, axis) => parts[(axis + 2 - upright) % 3]);
  return {
    right: direction(-sa, ca, 0),
    up: direction(-ca * se, -sa * se, ce),
    towards: direction(ca * ce, sa * ce, se),
  };
}

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** A point of space in the picture's plane. */
export const along = ({ right, up }, point) => [dot(right, point), dot(up, point)];
