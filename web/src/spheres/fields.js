import { unpack } from "../block.js";
import { decodeField } from "../field/decode.js";
import { linearScale } from "../field/scale.js";
import { aboutLayer, inOrder, known, valuesOf } from "../figures/coarse_fields.js";
import { text } from "../text.js";

/** The coarse-grained fields of one state, on cells of its container (x fastest, then y, then z); each is decoded when
    first asked for. */
class FieldsOfState {
  constructor(block, about) {
    Object.assign(this, about, { size: about.cells[0] * about.cells[1] * about.cells[2] });
    this.reached = about.reached && unpack(block, about.reached);
    this.sides = about.high.map((end, axis) => end - about.low[axis]);
    for (const [name, layer] of Object.entries(about.layers)) this.#addLayer(name, block, layer);
  }

  /** Unknown where no grain is in reach. */
  #addLayer(name, block, about) {
    let values = null;
    const get = () => {
      if (values) return values;
      values = decodeField(this.cells[0], unpack(block, about.residual), about);
      if (this.reached) values = values.map((value, k) => (this.reached[k] ? value : NaN));
      return values;
    };
    Object.defineProperty(this, name, { get, enumerable: true });
  }

  /** The middle of a layer of cells, m. */
  place(axis, layer) {
    return this.low[axis] + ((layer + 0.5) * this.sides[axis]) / this.cells[axis];
  }
}

/** The fields of a stage, of which those of one state are shown, as a sample to be sliced (space/slices.js). */
export class CoarseFields {
  #block;
  #states = new Map();
  #layer = {};

  constructor(result, block) {
    Object.assign(this, { about: result.about, title: result.title, name: result.name });
    this.#block = block;
    this.places = result.states.flatMap(({ fields }, k) => (fields ? [k] : []));
    this.size = this.last.cells;
    this.show(this.places.at(-1));
  }

  #opened(k) {
    if (!this.#states.has(k)) this.#states.set(k, new FieldsOfState(this.#block, this.about.states[k].fields));
    return this.#states.get(k);
  }
  get last() {
    return this.#opened(this.places.at(-1));
  }
  /** Those that any state has: [[name, what is said of it]]. */
  get offered() {
    return known(Object.assign({}, ...this.places.map((k) => this.about.states[k].fields.layers)), this);
  }

  /** Those of a state, or of the nearest that has them. */
  show(snapshot) {
    const away = this.places.map((place) => Math.abs(place - snapshot));
    this.shown = this.places[away.lastIndexOf(Math.min(...away))];
    this.state = this.#opened(this.shown);
  }
  get sides() {
    return this.state.sides;
  }
  placed(axis, layer) {
    return text.quantity(this.state.place(axis, layer), "m");
  }

  /** A field of the state shown: what is said of it, values, and their scale from end to end of the colours. One that
      rests in this state is 0. */
  layer(name) {
    const key = `${this.shown} ${name}`;
    if (this.#layer.key === key) return this.#layer;
    const about = aboutLayer(name, this.about),
      there = known(this.state, this).some(([one]) => one === name),
      values = there ? valuesOf(this.state, name, this.about) : this.#still(),
      ends = this.state.ends[name] ?? [-1, 1];
    return (this.#layer = { key, ...about, values, scale: linearScale(inOrder(values), ends) });
  }
  #still() {
    return Float32Array.from({ length: this.state.size }, (_, k) => (this.state.reached?.[k] === 0 ? NaN : 0));
  }

  indexOf(cell) {
    const [width, height] = this.size;
    return cell[0] + width * (cell[1] + height * cell[2]);
  }
}
