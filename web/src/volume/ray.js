const least = 1e-6; // of a direction's components, so that none divides by zero

/** The first voxel that is seen along the line of sight through the point (u, v) of the picture, in voxels from the
    middle of a sample of `size`, of which `kept` voxels are left along each axis: its three indices, or null. As the
    graphics card follows it (shaders.js), from face to face. */
export function seenCell({ right, up, towards }, [u, v], size, kept, isSeen) {
  const far = Math.hypot(...size),
    start = size.map((n, a) => n / 2 + u * right[a] + v * up[a] + far * towards[a]),
    way = towards.map((t) => (Math.abs(t) < least ? least : -t));
  const ends = [0, 1, 2].map((a) => [-start[a] / way[a], (kept[a] - start[a]) / way[a]]),
    enter = Math.max(...ends.map((pair) => Math.min(...pair))),
    leave = Math.min(...ends.map((pair) => Math.max(...pair)));
  if (enter >= leave) return null;
  const cell = start.map((s, a) => Math.min(kept[a] - 1, Math.max(0, Math.floor(s + way[a] * (enter + 1e-4))))),
    step = way.map(Math.sign),
    next = cell.map((c, a) => (c + Math.max(step[a], 0) - start[a]) / way[a]);
  for (;;) {
    if (isSeen(cell)) return cell;
    const a = next.indexOf(Math.min(...next));
    cell[a] += step[a];
    if (cell[a] < 0 || cell[a] >= kept[a]) return null;
    next[a] += Math.abs(1 / way[a]);
  }
}
