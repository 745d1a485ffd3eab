import { unpacked } from "../block.js";
import { DescribedResult } from "../described_result.js";
import { prefixOf, text } from "../text.js";
import { CoarseFields } from "./fields.js";

const whole = 100; // steps of a cut along an axis

const mostOpen = 24; // states whose arrays are kept

/** A stage of a sample of spheres with its stored states, of which one is shown; places count from the middle of the
    last state's container, m. */
export class SphereResult extends DescribedResult {
  #block;
  #states = new Map();
  #shown;
  #orders = new Map();

  constructor(about, block, title) {
    super(about, block, title);
    this.#block = block;
    this.states = about.states ?? [];
    this.snapshotCount = this.states.length;
    this.#shown = this.snapshotCount - 1;
    this.finders = findersOf(about.quantities ?? {});
  }

  show(snapshot) {
    this.#shown = snapshot;
  }
  get state() {
    return this.#opened(this.#shown);
  }
  snapshot(k) {
    return this.#opened(k);
  }
  get last() {
    return this.#opened(this.snapshotCount - 1);
  }
  /** Without a stored state: no spheres in a container of no size. */
  #opened(k) {
    if (!this.#states.has(k)) {
      if (this.#states.size > mostOpen) this.#states.clear();
      const { fields: _, ...stored } = this.states[k] ?? nothing,
        about = unpacked(this.#block, stored);
      this.#states.set(k, opened(about, k < this.snapshotCount - 1 ? this.last : null));
    }
    return this.#states.get(k);
  }
  /** Coarse-grained fields of its states, or null. */
  coarseFields() {
    return this.#has("fields") ? new CoarseFields(this, this.#block) : null;
  }
  /** Whether any state has it. */
  #has(part) {
    return this.states.some((state) => state[part]);
  }
  /** Figures over a stage have a place for every stored state, of which the page may have but some. */
  stepAt(state) {
    return this.states[state.get("snapshot")]?.place ?? 0;
  }
  stateAt(place) {
    const away = this.states.map((state) => Math.abs(state.place - place));
    return away.indexOf(Math.min(...away));
  }

  get count() {
    return this.state.radius.length;
  }
  get size() {
    return this.state.container.size;
  }
  get meanRadius() {
    return this.state.mean_radius;
  }
  get materials() {
    return this.state.materials;
  }
  get id() {
    return this.state.id;
  }
  get material() {
    return this.state.material;
  }
  materialName(sphere) {
    return text.material(this.materials[this.material[sphere]]);
  }
  /** What a figure has on its abscissa of a sphere, SI: figures are of the last state. */
  abscissaOf(sphere, what) {
    return what === "diameter" ? 2 * this.last.radius[sphere] : this.last.stress?.[sphere];
  }
  get hasForces() {
    return this.#has("forces");
  }
  get hasBonds() {
    return this.#has("bonds");
  }
  get hasBoundaries() {
    return this.#has("boundaries");
  }

  /** What the program says of a quantity of the last state, whose colours all have: { label, symbol, unit, magnitude,
      mean }. */
  quantity(id) {
    return this.last.quantities[id];
  }
  /** Those that are not the same of all spheres of the last state. */
  get offered() {
    return Object.keys(this.last.quantities).filter((id) => this.order(id)[0] < this.order(id).at(-1));
  }
  /** Of the last state, so that one scale of colours serves all. */
  order(id) {
    if (!this.#orders.has(id)) this.#orders.set(id, Float32Array.from(this.last[id]).sort());
    return this.#orders.get(id);
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

  /** How far from the middle of the last container anything may lie, whichever state is shown. */
  get reach() {
    const middle = middleOf(this.last.container);
    return Math.max(
      ...(this.states.length ? this.states : [nothing]).map(({ container }) => {
        const off = middleOf(container).map((place, axis) => place - middle[axis]);
        return Math.hypot(...off) + Math.hypot(...container.size) / 2;
      }),
    );
  }

  /** Where a cut along an axis lies; beyond all where nothing is cut. */
  place(axis, cut) {
    return cut >= whole ? Infinity : this.state.shift[axis] + (cut / whole - 0.5) * this.size[axis];
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

/** How the page finds the numbers of every sphere (quantities.js): but for its size a state has them by their names. */
const findersOf = (quantities) =>
  Object.fromEntries(
    Object.keys(quantities).map((id) => [
      id,
      { find: (_, state) => (id === "size" ? state.radius.map((r) => 2 * r) : state[id]) },
    ]),
  );

const nothing = {
  container: { corner: [0, 0, 0], size: [1, 1, 1], periodic: [false, false, false], tilt: 0, walls: [] },
  materials: [],
  id: [],
  x: [],
  y: [],
  z: [],
  radius: [],
  mean_radius: 0,
  material: [],
  quantities: {},
};

const middleOf = ({ corner, size }) => corner.map((place, axis) => place + size[axis] / 2);

const none = { i: [], j: [], fn: [], all: 0, broken: [], x: [], y: [], z: [] };

/** With spheres as [x, y, z, radius] one after the other, and how far the middle of the container lies from that of the
    `last` state's, which has what is the same in all and names what a state may lack. */
function opened(state, last) {
  const all = last ? { ...inherited(last), ...state } : state,
    middle = middleOf(last?.container ?? state.container),
    balls = new Float32Array(4 * all.radius.length);
  [all.x, all.y, all.z].forEach((places, axis) => {
    for (let g = 0; g < places.length; ++g) balls[4 * g + axis] = places[g] - middle[axis];
  });
  for (let g = 0; g < all.radius.length; ++g) balls[4 * g + 3] = all.radius[g];
  for (const id of Object.keys(all.quantities)) all[id] ??= new Float32Array(all.radius.length);
  return {
    ...all,
    balls,
    middle,
    shift: middleOf(all.container).map((place, axis) => place - middle[axis]),
    forces: all.forces ?? none,
    force_scale: all.force_scale ?? { mean: 0, tension: 0 },
    bonds: all.bonds ?? none,
    boundaries: all.boundaries ?? [],
  };
}

const inherited = ({ materials, id, radius, mean_radius, material, quantities }) => ({
  materials,
  id,
  radius,
  mean_radius,
  material,
  quantities,
});
