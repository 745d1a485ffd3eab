import { opened } from "./block.js";
import { Numbers } from "./declared.js";

/** A result with numbers and figures of its own, but no packing: a field, a film, a sample in space. */
export class DescribedResult {
  #block;

  constructor(about, block, title) {
    this.#block = block;
    Object.assign(this, {
      about,
      title,
      name: about.name,
      declared: new Numbers(about.numbers, about.meanings, about.elsewhere),
    });
  }

  get resultName() {
    return this.name;
  }

  /** Figures ask for the texture of a packing. */
  texture() {
    return null;
  }

  /** What a figure shows; undefined where that is nothing. */
  ofRun(id) {
    return opened(this.#block, this.about, id);
  }
  /** What a figure shows, and the step that the reader is at. */
  drawn(id, state) {
    const drawings = opened(this.#block, this.about, id);
    return drawings ? { drawings, here: this.stepAt(state) } : null;
  }
  stepAt() {
    return 0;
  }
  hasDrawn(id) {
    return Boolean(this.about.figures[id]);
  }
}
