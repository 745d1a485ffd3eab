import { isPresent } from "../sample.js";
import { distanceToSegment } from "../segment.js";
import { chainWidth, isShown, segmentsOf } from "./chains.js";

/** Finds the grain or the contact at a point of the plane. Grains are kept in square cells of the largest diameter. */
export class Picker {
  constructor(sample, snapshot) {
    this.sample = sample;
    this.snapshot = snapshot;
    const { x, y } = snapshot;
    this.cell = 2 * sample.radius.reduce((most, r) => Math.max(most, r), 0) || 1;
    this.left = x.reduce((least, v) => (v < least ? v : least), Infinity);
    this.bottom = y.reduce((least, v) => (v < least ? v : least), Infinity);
    this.cells = new Map();
    for (let g = 0; g < sample.count; ++g) {
      if (!isPresent(snapshot, g)) continue;
      const key = this.#key(this.#column(x[g]), this.#row(y[g]));
      if (!this.cells.has(key)) this.cells.set(key, []);
      this.cells.get(key).push(g);
    }
  }

  #column(x) {
    return Math.floor((x - this.left) / this.cell);
  }
  #row(y) {
    return Math.floor((y - this.bottom) / this.cell);
  }
  #key(column, row) {
    return column * 65536 + row;
  }

  #near(x, y) {
    const near = [];
    for (let column = this.#column(x) - 1; column <= this.#column(x) + 1; ++column)
      for (let row = this.#row(y) - 1; row <= this.#row(y) + 1; ++row)
        near.push(...(this.cells.get(this.#key(column, row)) ?? []));
    return near;
  }

  grain(x, y) {
    const { snapshot, sample } = this;
    return this.#near(x, y).find((g) => Math.hypot(snapshot.x[g] - x, snapshot.y[g] - y) <= sample.radius[g]) ?? null;
  }

  /** The shown contact whose chain lies within `reach` (m) of the point; the strongest of them. */
  contact(x, y, reach, state) {
    const { snapshot, sample } = this;
    const { start, list } = sample.contactsByGrain(snapshot);
    let found = null;
    for (const g of this.#near(x, y)) {
      for (let k = start[g]; k < start[g + 1]; ++k) {
        const c = list[k],
          fn = Math.abs(snapshot.contacts.fn[c]);
        if (
          fn === 0 ||
          !isShown(state, sample, snapshot, c) ||
          (found !== null && fn <= Math.abs(snapshot.contacts.fn[found]))
        )
          continue;
        const half = chainWidth(sample, snapshot, fn) / 2;
        if (
          segmentsOf(sample, snapshot, c).some((segment) => distanceToSegment(segment, x, y) <= Math.max(half, reach))
        )
          found = c;
      }
    }
    return found;
  }
}
