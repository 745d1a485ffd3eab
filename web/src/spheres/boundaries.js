const thin = 0.22; // radius of an edge over the mean radius of the spheres

/** The edges of the faces of boundaries that are there, as lines of force are: { ends, radius, kind }. */
export function edgesOf({ state: { boundaries, middle }, meanRadius }) {
  const ends = boundaries
      .filter(({ present }) => present)
      .flatMap((boundary) => Array.from(boundary.ends, (place, k) => place - middle[k % 3])),
    count = ends.length / 6;
  return {
    ends: new Float32Array(ends),
    radius: new Float32Array(count).fill(thin * meanRadius),
    kind: Array(count).fill("boundary"),
  };
}
