import { unpack, unpacked } from "../block.js";
import { DescribedResult } from "../described_result.js";
import { evaluate, evaluateAll, namesIn } from "../formula.js";
import { decodeField } from "./decode.js";

/** The kind of nodes that nothing fills; what the others are called the program says (drawn.js). */
export const empty = 0;

/** The sample on a grid: kind and grain label (0: none) of every node, and the kind of every grain. */
export class PhaseMap {
  constructor(about, block) {
    Object.assign(this, { about, width: about.width, height: about.height, stride: about.stride });
    this.spacing = about.dx * about.stride;
    this.label = unpack(block, about.label);
    this.kind = unpack(block, about.kind);
    this.grainKind = unpack(block, about.grain_kind);
    this.cavities = unpacked(block, about.cavities ?? {});
  }

  get size() {
    return this.kind.length;
  }
  get box() {
    return { left: 0, bottom: 0, right: this.width * this.spacing, top: this.height * this.spacing };
  }
  /** Of all nodes of the map, of which the page has some. */
  share(kind) {
    return this.about.fractions[kind];
  }
  kindOfGrain(g) {
    return this.grainKind[g];
  }

  /** Index of the node at a point of the plane, or null. */
  nodeAt(x, y) {
    const column = Math.floor(x / this.spacing),
      row = Math.floor(y / this.spacing);
    return column >= 0 && row >= 0 && column < this.width && row < this.height ? column + this.width * row : null;
  }

  /** Middle of a node of the page; it stands for stride x stride nodes of the whole map. */
  placeOf(node) {
    return [((node % this.width) + 0.5) * this.spacing, (Math.floor(node / this.width) + 0.5) * this.spacing];
  }
}

/** A result on a grid: fields are decoded when first asked for. */
export class FieldResult extends DescribedResult {
  #block;
  #values = new Map();

  constructor(about, maps, block, title) {
    super(about, block, title);
    this.#block = block;
    this.map = maps[about.map];
    for (const name of ["curve", "grains", "cracks"]) this[name] = unpacked(block, about[name] ?? null);
    this.steps = this.curve.strain?.length ?? 0;
    /** Mean stress sigma_yy over the nodes that are not void; what sizes are compared with. */
    this.mean = this.stored("yy")?.mean ?? null;
  }

  /** The step of the test that the reader is at. */
  stepAt(state) {
    return Math.min(state.get("step"), this.steps - 1);
  }

  get loaded() {
    return this.has("yy");
  }

  /** Size that "strong" is measured by. */
  get scale() {
    return this.about.scale;
  }

  /** The component of stress by which the load acts. */
  get actsBy() {
    return this.about.acts_by ?? "yy";
  }

  /** A stress against the mean of the sample, [symbol, number]: `of(id)` at a node or of a grain. */
  relative(of) {
    const { symbol, formula } = this.about.relative;
    return [symbol, evaluate(formula, (name) => (name === "mean" ? this.mean : of(name)))];
  }

  /** What the program says of a quantity: { name, symbol, unit, formula, offered, magnitude }. */
  quantity(id) {
    return this.about.quantities[id];
  }
  /** A quantity as it is stored; undefined where it is formed of others. */
  stored(id) {
    return this.about.components[this.quantity(id)?.name];
  }
  has(id) {
    const about = this.quantity(id);
    return about !== undefined && namesIn(about.formula).every((name) => this.stored(name) !== undefined);
  }

  /** Those that can be painted. */
  get offered() {
    return Object.keys(this.about.quantities).filter((id) => this.quantity(id).offered && this.has(id));
  }

  unitOf(id) {
    return this.quantity(id).unit;
  }

  values(name) {
    if (!this.#values.has(name)) this.#values.set(name, this.#make(name));
    return this.#values.get(name);
  }

  #make(id) {
    const about = this.stored(id);
    return about
      ? decodeField(this.map.width, unpack(this.#block, about.residual), about)
      : evaluateAll(this.quantity(id).formula, this.map.size, (name) => this.values(name));
  }

  /** A quantity at one node. */
  atNode(id, node) {
    return evaluate(this.quantity(id).formula, (name) => this.values(name)[node]);
  }

  /** A quantity by the mean stress of grain g (from 0). */
  ofGrain(id, g) {
    return evaluate(this.quantity(id).formula, (name) => this.grains[name][g]);
  }
  /** Whether grains have it: their mean stresses are known, no displacements. */
  grainsHave(id) {
    return namesIn(this.quantity(id).formula).every((name) => this.grains[name] !== undefined);
  }

  /** Radius of the disk of the grain's area, m. */
  radiusOfGrain(g) {
    return this.grains.radius[g];
  }

  /** Rectangle around the nodes of grain g. */
  boxOfGrain(g) {
    if (!this.boxes) this.boxes = boxes(this.map, this.grains.nodes.length);
    const [left, bottom, right, top] = this.boxes.subarray(4 * g, 4 * g + 4),
      d = this.map.spacing;
    return { left: left * d, bottom: bottom * d, right: (right + 1) * d, top: (top + 1) * d };
  }
}

function boxes({ label, width }, grains) {
  const list = new Int32Array(4 * grains);
  for (let g = 0; g < grains; ++g) list.set([1e9, 1e9, -1, -1], 4 * g);
  for (let k = 0; k < label.length; ++k) {
    if (label[k] === 0) continue;
    const at = 4 * (label[k] - 1),
      x = k % width,
      y = Math.floor(k / width);
    list[at] = Math.min(list[at], x);
    list[at + 1] = Math.min(list[at + 1], y);
    list[at + 2] = Math.max(list[at + 2], x);
    list[at + 3] = Math.max(list[at + 3], y);
  }
  return list;
}
