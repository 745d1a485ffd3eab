import { along, dot } from "../space/frame.js";

/** The sphere ([x, y, z, radius] one after the other) that the line of sight through a point of the picture's plane
    meets first, without those beyond a cut; or null. */
export function seenSphere(frame, [u, v], balls, kept) {
  let seen = null,
    nearest = -Infinity;
  for (let g = 0; 4 * g < balls.length; ++g) {
    const ball = balls.subarray(4 * g, 4 * g + 4);
    if (kept.some((end, axis) => ball[axis] > end)) continue;
    const [x, y] = along(frame, ball),
      ahead = ball[3] ** 2 - (u - x) ** 2 - (v - y) ** 2;
    if (ahead < 0) continue;
    const depth = dot(frame.towards, ball) + Math.sqrt(ahead);
    if (depth > nearest) [seen, nearest] = [g, depth];
  }
  return seen;
}
