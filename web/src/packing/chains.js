import { kindOfForce, widthOfForce } from "../drawn.js";
import { bytes } from "../theme.js";

/** Width of the chain of a contact force, m. */
export const chainWidth = (sample, snapshot, fn) => widthOfForce(fn, snapshot.meanForce, sample.meanRadius);

export function isShown(state, sample, snapshot, c) {
  const { fn, type } = snapshot.contacts;
  if (!state.get("types").has(type[c])) return false;
  const strength = state.get("strength");
  if (strength === "all") return true;
  if (strength === "tensile") return fn[c] < snapshot.tensile;
  return fn[c] > snapshot.meanForce === (strength === "strong");
}

export const chainColour = (theme, { meanForce: mean, tensile: tension }, fn) =>
  theme[kindOfForce(fn, { mean, tension })];

/** What a grain touches of the boundaries: elements are counted through all of them, two a point, the point and the
    segment to the next. */
export function boundaryElement(snapshot, element) {
  let number = element;
  for (const boundary of snapshot.boundaries) {
    const points = boundary.x.length;
    if (number < 2 * points)
      return { boundary, from: number >> 1, to: number % 2 ? ((number >> 1) + 1) % points : number >> 1 };
    number -= 2 * points;
  }
  return null;
}

/** Where a place touches an element: the foot on its line, and the distance to the element itself. */
function footOn({ boundary, from, to }, x, y) {
  const ax = boundary.x[from],
    ay = boundary.y[from],
    dx = boundary.x[to] - ax,
    dy = boundary.y[to] - ay;
  const squared = dx * dx + dy * dy;
  const share = squared > 0 ? ((x - ax) * dx + (y - ay) * dy) / squared : 0,
    within = Math.min(Math.max(share, 0), 1);
  return { foot: [ax + share * dx, ay + share * dy], distance: Math.hypot(x - ax - within * dx, y - ay - within * dy) };
}

/** The foot on an element of that image of a grain at (x, y) that is nearest to it, and how far the image is shifted.
 */
function nearestFoot(element, box, domain, x, y) {
  const { boundary, from, to } = element;
  const [sx, sy] = nearestImage(box, domain, [
    x - (boundary.x[from] + boundary.x[to]) / 2,
    y - (boundary.y[from] + boundary.y[to]) / 2,
  ]);
  const images = [];
  for (const up of domain.periodic[1] ? [0, -1, 1] : [0])
    for (const across of domain.periodic[0] ? [0, -1, 1] : [0]) {
      const shift = [sx + across * (box.right - box.left), sy + up * (box.top - box.bottom)];
      images.push({ shift, ...footOn(element, x + shift[0], y + shift[1]) });
    }
  return images.reduce((best, image) => (image.distance < best.distance ? image : best));
}

/** The segments of one contact: centre to centre, or centre to wall; through a periodic side it is drawn at both. */
export function segmentsOf(sample, snapshot, c) {
  const { i, j } = snapshot.contacts;
  const a = i[c],
    b = j[c];
  const x = snapshot.x[a],
    y = snapshot.y[a];
  if (b >= sample.count) {
    const side = b - sample.count;
    if (side > 3) {
      const { foot, shift } = nearestFoot(
        boundaryElement(snapshot, side - 4),
        sample.box(snapshot),
        snapshot.domain,
        x,
        y,
      );
      return fromBothEnds([x, y], foot, shift);
    }
    // Ends short of the wall by half the chain's width, so that the round end touches it.
    const inwards = side % 2 === 0 ? 1 : -1;
    const position =
      snapshot.domain.walls[side].position + (inwards * chainWidth(sample, snapshot, snapshot.contacts.fn[c])) / 2;
    return [side < 2 ? [x, y, position, y] : [x, y, x, position]];
  }
  const end = [snapshot.x[b], snapshot.y[b]];
  return fromBothEnds([x, y], end, nearestImage(sample.box(snapshot), snapshot.domain, [x - end[0], y - end[1]]));
}

/** One segment where both ends are in one cell; else one from each end to the other's image. */
function fromBothEnds([x, y], end, [sx, sy]) {
  if (sx === 0 && sy === 0) return [[x, y, ...end]];
  return [
    [x, y, end[0] - sx, end[1] - sy],
    [x + sx, y + sy, ...end],
  ];
}

/** The shift that takes a vector between two places to its nearest image. */
function nearestImage(box, domain, [dx, dy]) {
  const [periodicX, periodicY] = domain.periodic;
  let sx = 0,
    sy = 0;
  if (periodicY) {
    const n = Math.round(dy / (box.top - box.bottom));
    if (n) {
      sy = -n * (box.top - box.bottom);
      sx = -n * domain.tilt;
    }
  }
  if (periodicX) {
    const n = Math.round((dx + sx) / (box.right - box.left));
    if (n) sx -= n * (box.right - box.left);
  }
  return [sx, sy];
}

/** The shown contacts, weakest first, so that the strong lie on top. */
export function shownContacts(state, sample, snapshot) {
  const { fn } = snapshot.contacts;
  const shown = [];
  for (let c = 0; c < fn.length; ++c) if (fn[c] !== 0 && isShown(state, sample, snapshot, c)) shown.push(c);
  return shown.sort((p, q) => Math.abs(fn[p]) - Math.abs(fn[q]));
}

/** Segments for the graphics card: ends relative to `origin`, widths, colours. */
export function chainBuffers(state, sample, snapshot, theme, origin) {
  const shown = shownContacts(state, sample, snapshot);
  const ends = new Float32Array(8 * shown.length),
    width = new Float32Array(2 * shown.length),
    colour = new Uint8Array(8 * shown.length);
  const paints = new Map();
  let count = 0;
  for (const c of shown) {
    const fn = snapshot.contacts.fn[c],
      name = chainColour(theme, snapshot, fn);
    if (!paints.has(name)) paints.set(name, [...bytes(name), name === theme.weak ? 190 : 255]);
    for (const [ax, ay, bx, by] of segmentsOf(sample, snapshot, c)) {
      ends.set([ax - origin.x, ay - origin.y, bx - origin.x, by - origin.y], 4 * count);
      width[count] = chainWidth(sample, snapshot, fn);
      colour.set(paints.get(name), 4 * count++);
    }
  }
  return {
    ends: ends.subarray(0, 4 * count),
    width: width.subarray(0, count),
    colour: colour.subarray(0, 4 * count),
    count,
  };
}
