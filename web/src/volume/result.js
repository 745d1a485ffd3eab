import { unpack } from "../block.js";
import { DescribedResult } from "../described_result.js";
import { prefixOf, text } from "../text.js";

const codes = 254; // steps between the ends of a quantity; code 0 is the void
const mostOrdered = 8192;

/** Parts of the codes among which a level surface is chosen. */
export const levels = 20;
export const phases = { empty: 0, matrix: 1, particle: 2 };

/** A sample in space: phases and quantities of its voxels (x fastest, then y, then z), unpacked when first asked
    for. */
export class VolumeResult extends DescribedResult {
  #block;
  #codes = new Map();
  #orders = new Map();

  constructor(about, block, title) {
    super(about, block, title);
    this.#block = block;
    Object.assign(this, {
      size: about.size,
      spacing: about.dx * about.stride,
      phase: unpack(block, about.phase),
    });
    /** Without a side of the voxels lengths are in voxels. */
    this.inVoxels = about.in_voxels;
    this.phases = [phases.matrix, phases.particle].filter((phase) => this.share(phase) > 0);
  }

  /** How long it is along each axis, in voxels. */
  get sides() {
    return this.size;
  }

  /** Fraction of the volume that is of a phase. */
  share(phase) {
    return this.declared.at(`map.phases.${["void", "matrix", "particle"][phase]}`) ?? 0;
  }

  quantity(id) {
    return this.about.quantities[id];
  }
  get offered() {
    return Object.keys(this.about.quantities).filter((id) => this.quantity(id).code);
  }
  unitOf(id) {
    const { unit } = this.quantity(id);
    return unit === "m" && this.inVoxels ? "voxels" : unit;
  }

  /** The component that the load acts by. */
  get loaded() {
    return this.about.acts_by;
  }

  codes(id) {
    if (!this.#codes.has(id)) this.#codes.set(id, unpack(this.#block, this.quantity(id).code));
    return this.#codes.get(id);
  }
  valueOfCode(id, code) {
    const { low, high } = this.quantity(id);
    return low + ((code - 1) * (high - low)) / codes;
  }

  /** The code that a share of the codes begins with, in `levels` parts; below it voxels are not seen. */
  codeOfLevel(level) {
    return 1 + Math.round((level * codes) / levels);
  }

  /** A value as text; at the ends of its codes it may lie beyond. */
  written(id, voxel) {
    const code = this.codes(id)[voxel],
      { low, high, least, most } = this.quantity(id);
    const beyond = code === 1 && least < low ? "\u2264\u2009" : code > codes && most > high ? "\u2265\u2009" : "";
    return beyond + text.quantity(this.valueOfCode(id, code), this.unitOf(id));
  }

  /** Values of the voxels that are not void in order, thinned to what a histogram needs; those of one code are spread
      over its width. */
  order(id) {
    if (!this.#orders.has(id)) this.#orders.set(id, orderOf(this, id));
    return this.#orders.get(id);
  }

  /** The voxel at three indices, or null. */
  voxelAt(cell) {
    const [width, height] = this.size;
    return cell.every((c, a) => c >= 0 && c < this.size[a]) ? cell[0] + width * (cell[1] + height * cell[2]) : null;
  }

  /** A place along an axis from the sample's corner: the middle of a layer, or its end with `within` 1. */
  place(layer, within = 0.5) {
    return (layer + within) * this.spacing;
  }
  /** The same of the layer that a slice shows, in words. */
  placed(_, layer) {
    return this.length(this.place(layer));
  }
  length(value) {
    return this.lengths([value]);
  }
  /** Several in one unit. */
  lengths(values) {
    const { factor, unit } = this.inVoxels ? { factor: 1, unit: "voxels" } : prefixOf(Math.max(...values), "m");
    return `${values.map((value) => text.number(value / factor, 3)).join(", ")}\u202f${unit}`;
  }
}

function orderOf(result, id) {
  const counts = new Uint32Array(codes + 2);
  for (const code of result.codes(id)) ++counts[code];
  const known = counts.subarray(1).reduce((sum, n) => sum + n, 0),
    order = new Float32Array(Math.min(known, mostOrdered)),
    { low, high } = result.quantity(id);
  for (let k = 0, code = 1, before = 0; k < order.length; ++k) {
    const rank = ((k + 0.5) * known) / order.length;
    while (rank >= before + counts[code]) before += counts[code++];
    const value = result.valueOfCode(id, code - 0.5 + (rank - before) / counts[code]);
    order[k] = Math.min(high, Math.max(low, value));
  }
  return order;
}
