import { unpacked } from "../block.js";
import { DescribedResult } from "../described_result.js";
import { prefixOf, text } from "../text.js";

/** What spheres are coloured by beside their material: symbol and unit, and whether it is never below 0. */
const quantities = {
  stress: { symbol: "\u03c3_{hyd}", unit: "Pa" },
  contacts: { symbol: "contacts", unit: "", magnitude: true },
  speed: { symbol: "|v|", unit: "m/s", magnitude: true },
};

const whole = 100; // steps of a cut along an axis

/** A stage of a sample of spheres with its last state; places count from the middle of the container, m. */
export class SphereResult extends DescribedResult {
  #block;
  #state;
  #orders = new Map();

  constructor(about, block, title) {
    super(about, block, title);
    this.#block = block;
  }

  /** Without a stored state: no spheres in a container of no size. */
  get state() {
    return (this.#state ??= opened(unpacked(this.#block, this.about.state ?? nothing)));
  }
  get count() {
    return this.state.radius.length;
  }
  get size() {
    return this.state.container.size;
  }
  get meanRadius() {
    return this.state.radius.reduce((sum, r) => sum + r, 0) / Math.max(1, this.count);
  }
  get materials() {
    return this.state.materials;
  }
  get hasForces() {
    return Boolean(this.state.forces);
  }
  get hasBonds() {
    return Boolean(this.state.bonds);
  }
  get hasBoundaries() {
    return Boolean(this.state.boundaries);
  }

  quantity(id) {
    return quantities[id];
  }
  /** Those that its state has, and that are not the same of all spheres. */
  get offered() {
    return Object.keys(quantities).filter((id) => this.state[id] && this.order(id)[0] < this.order(id).at(-1));
  }
  order(id) {
    if (!this.#orders.has(id)) this.#orders.set(id, Float32Array.from(this.state[id]).sort());
    return this.#orders.get(id);
  }
  mean(id) {
    return this.order(id).reduce((sum, value) => sum + value, 0) / this.count;
  }
  written(id, sphere) {
    const { unit } = this.quantity(id),
      value = this.state[id][sphere];
    return unit ? text.quantity(value, unit) : text.count(value);
  }

  /** Mean force of the contacts that push. */
  get meanForce() {
    return this.state.force_scale.mean;
  }

  /** Where a cut along an axis lies, from the middle; beyond all where nothing is cut. */
  place(axis, cut) {
    return cut >= whole ? Infinity : (cut / whole - 0.5) * this.size[axis];
  }
  /** The same from the container's corner, in words. */
  length(axis, cut) {
    return cut >= whole ? "all" : text.quantity((cut / whole) * this.size[axis], "m");
  }
  lengths(values) {
    const { factor, unit } = prefixOf(Math.max(...values.map(Math.abs)), "m");
    return `${values.map((value) => text.number(value / factor, 3)).join(", ")}\u202f${unit}`;
  }
}

export const cuts = [0, whole];

const nothing = {
  container: { corner: [0, 0, 0], size: [1, 1, 1], periodic: [false, false, false], tilt: 0, walls: [] },
  materials: [],
  id: [],
  x: [],
  y: [],
  z: [],
  radius: [],
  material: [],
};

/** Spheres as [x, y, z, radius] one after the other, from the middle of the container. */
function opened(state) {
  const { corner, size } = state.container,
    balls = new Float32Array(4 * state.radius.length);
  [state.x, state.y, state.z].forEach((places, axis) => {
    const middle = corner[axis] + size[axis] / 2;
    for (let g = 0; g < places.length; ++g) balls[4 * g + axis] = places[g] - middle;
  });
  for (let g = 0; g < state.radius.length; ++g) balls[4 * g + 3] = state.radius[g];
  return { ...state, balls };
}
