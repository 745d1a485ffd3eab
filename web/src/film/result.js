import { unpack, unpacked } from "../block.js";
import { DescribedResult } from "../described_result.js";
import { decodeField } from "../field/decode.js";

/** A film of a loaded packing: maps are decoded when first asked for; grains in pixels, y down. */
export class FilmResult extends DescribedResult {
  #block;
  #values = new Map();

  constructor(about, block, title) {
    super(about, block, title);
    this.#block = block;
    Object.assign(this, { materials: about.materials, container: about.container });
    this.width = about.film.width;
    this.height = about.film.height;
    for (const name of ["grains", "contacts", "bad", "stresses"]) this[name] = unpacked(block, about[name]);
    for (const [name, source] of Object.entries(this.stresses))
      source.statistics = about.numbers.stresses?.[name] ?? {};
    this.meanForce = about.force_scale.mean;
    this.meanRadius = this.grains.mean_radius || 1;
  }

  get count() {
    return this.grains.count;
  }
  get hasForces() {
    return this.contacts.count > 0 && this.contacts.fn?.some((force) => force !== 0);
  }
  get hasSimulation() {
    return Boolean(this.stresses.film && (this.stresses.simulation_peak_to_peak || this.stresses.simulation_state));
  }
  get box() {
    return { left: -0.5, right: this.width - 0.5, bottom: 0.5 - this.height, top: 0.5 };
  }
  unitOf(map) {
    return this.about.maps[map].unit;
  }

  /** A contact that counts as there, and by its force and its gap may not be. */
  isUncertain(c) {
    return Boolean(this.contacts.may_be_absent[c]);
  }

  /** Where a contact's bar goes in the picture: centre to centre, or centre to the rim at a wall. */
  endsOf(c) {
    const { i, j, nx, ny } = this.contacts,
      { x, y, radius } = this.grains;
    const a = i[c],
      b = j[c];
    return b < this.count ? [x[a], y[a], x[b], y[b]] : [x[a], y[a], x[a] - radius[a] * nx[c], y[a] + radius[a] * ny[c]];
  }

  /** Number of the pixel under a point (column, row), or null. */
  pixelAt(x, y) {
    const column = Math.round(x),
      row = Math.round(y);
    return column >= 0 && row >= 0 && column < this.width && row < this.height ? column + this.width * row : null;
  }

  grainAt(x, y) {
    for (let g = 0; g < this.count; ++g)
      if (Math.hypot(this.grains.x[g] - x, this.grains.y[g] - y) <= this.grains.radius[g]) return g;
    return null;
  }

  /** Values as a map shows them; NaN where a pixel has none. */
  values(name) {
    if (!this.#values.has(name)) this.#values.set(name, this.#decoded(name));
    return this.#values.get(name);
  }

  #decoded(name) {
    const about = this.about.maps[name];
    if (about.on) return this.values(about.on);
    const values = decodeField(this.width, unpack(this.#block, about.residual), about);
    if (about.holes) for (const k of unpack(this.#block, about.holes)) values[k] = NaN;
    return values;
  }
}
