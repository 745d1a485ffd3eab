/** Distance of the point (x, y) from the segment [ax, ay, bx, by]. */
export function distanceToSegment([ax, ay, bx, by], x, y) {
  const dx = bx - ax,
    dy = by - ay;
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
