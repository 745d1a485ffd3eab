/** Grains that are no disks: their rims as the page holds them, and how they are filled and drawn. */

/** Points of a grain's rim as it lies in a snapshot, m. */
export function rimOf(sample, snapshot, g) {
  const { first, x, y } = sample.shapes,
    cos = Math.cos(snapshot.angle[g]),
    sin = Math.sin(snapshot.angle[g]);
  const points = [];
  for (let k = first[g]; k < first[g + 1]; ++k)
    points.push([snapshot.x[g] + cos * x[k] - sin * y[k], snapshot.y[g] + sin * x[k] + cos * y[k]]);
  return points;
}

const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
const holds = (a, b, c, p) => turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;

/** Triangles of a simple polygon, counter-clockwise, by cutting off ears: places of corners, three each. */
export function triangles(points) {
  const left = points.map((_, k) => k),
    found = [];
  const isEar = (at) => {
    const n = left.length,
      [a, b, c] = [left[(at + n - 1) % n], left[at], left[(at + 1) % n]];
    if (turn(points[a], points[b], points[c]) <= 0) return false;
    return left.every((k) => k === a || k === b || k === c || !holds(points[a], points[b], points[c], points[k]));
  };
  while (left.length > 3) {
    const n = left.length,
      ear = left.findIndex((_, at) => isEar(at)),
      at = ear < 0 ? 0 : ear;
    found.push(left[(at + n - 1) % n], left[at], left[(at + 1) % n]);
    left.splice(at, 1);
  }
  return [...found, ...left];
}

/** Which rim points the triangles of all grains join, and which grain each rim point belongs to. */
export function shapeMesh(sample) {
  const { first, x, y } = sample.shapes,
    corners = [],
    owner = new Uint32Array(x.length);
  for (let g = 0; g < sample.count; ++g) {
    const rim = Array.from(x.subarray(first[g], first[g + 1]), (value, k) => [value, y[first[g] + k]]);
    corners.push(...triangles(rim).map((k) => first[g] + k));
    owner.fill(g, first[g], first[g + 1]);
  }
  return { corners: Uint32Array.from(corners), owner };
}

/** Places of all rim points from an origin, and segments along the rims. */
export function shapePlaces(sample, snapshot, origin) {
  const { first, x } = sample.shapes,
    place = new Float32Array(2 * x.length),
    ends = new Float32Array(4 * x.length);
  for (let g = 0; g < sample.count; ++g) {
    const rim = rimOf(sample, snapshot, g);
    rim.forEach(([px, py], k) => {
      const [qx, qy] = rim[(k + 1) % rim.length],
        at = first[g] + k;
      place.set([px - origin.x, py - origin.y], 2 * at);
      ends.set([px - origin.x, py - origin.y, qx - origin.x, qy - origin.y], 4 * at);
    });
  }
  return { place, ends };
}

/** Fills triangles of rim points. */
export function shapeDrawing(regl) {
  return regl({
    vert: `
      precision highp float;
      attribute vec2 place;
      attribute vec4 colour;
      uniform vec2 middle, perMetre;
      varying vec4 fill;
      void main() {
        fill = colour;
        gl_Position = vec4((place - middle) * perMetre, 0.0, 1.0);
      }`,
    frag: `
      precision highp float;
      uniform vec3 background;
      uniform float fade;
      varying vec4 fill;
      void main() { gl_FragColor = vec4(mix(fill.rgb, background, fade), 1.0); }`,
    attributes: { place: regl.prop("place"), colour: { buffer: regl.prop("paint"), type: "uint8", normalized: true } },
    uniforms: {
      middle: regl.prop("middle"),
      perMetre: regl.prop("perMetre"),
      background: regl.prop("background"),
      fade: regl.prop("fade"),
    },
    elements: regl.prop("elements"),
    depth: { enable: false },
  });
}

/** Grains of any shape on the graphics card, as the scene holds disks. */
export class ShapeScene {
  constructor(regl, sample, segments) {
    this.sample = sample;
    this.fill = shapeDrawing(regl);
    this.segments = segments;
    const dynamic = () => regl.buffer({ usage: "dynamic", length: 4 }),
      mesh = shapeMesh(sample);
    this.owner = mesh.owner;
    this.elements = regl.elements({ data: mesh.corners, type: "uint32", primitive: "triangles" });
    this.buffers = { place: dynamic(), paint: dynamic(), ends: dynamic(), width: dynamic(), colour: dynamic() };
  }

  updatePositions(snapshot, origin) {
    const { place, ends } = shapePlaces(this.sample, snapshot, origin);
    this.buffers.place({ data: place, usage: "dynamic" });
    this.buffers.ends({ data: ends, usage: "dynamic" });
  }

  updateColours(ofGrains, ink) {
    const points = this.owner.length,
      paint = new Uint8Array(4 * points),
      rim = new Uint8Array(4 * points);
    this.owner.forEach((g, k) => {
      paint.set(ofGrains.subarray(4 * g, 4 * g + 4), 4 * k);
      rim.set([...ink, 150], 4 * k);
    });
    this.buffers.paint({ data: paint, usage: "dynamic" });
    this.buffers.colour({ data: rim, usage: "dynamic" });
    this.buffers.width({ data: new Float32Array(points).fill(0.04 * this.sample.meanRadius), usage: "dynamic" });
  }

  draw(view) {
    const { place, paint, ends, width, colour } = this.buffers;
    this.fill({ ...view, place, paint, elements: this.elements });
    this.segments({ ...view, ends, width, colour, count: this.owner.length });
  }
}
