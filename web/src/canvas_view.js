import { h, s } from "./dom.js";
import { gestures } from "./gestures.js";
import { Camera } from "./camera.js";
import { Tooltip } from "./tooltip.js";
import { themeOf } from "./theme.js";

/** A picture seen through a camera: canvas, overlay and legend, drawn at most once a frame after something has changed.
    Whoever extends it gives `extent` (the box that is seen as a whole), `update(stale)` (the parts of the scene that have
    changed), `paint()`, `drawOverlay()`, `legend()` and `pick(place)`, which sets `picked` to what lies under the pointer. */
export class CanvasView {
  constructor(state, { name, label, margin, key = "key", legendHeight, parts, beside = [] }) {
    Object.assign(this, { state, margin, legendHeight, camera: new Camera(), stale: new Set(parts), picked: null });
    this.canvas = h("canvas", { class: name, tabindex: 0, "aria-label": label });
    this.over = s("svg", { class: "over" });
    this.stage = h("div", { class: "stage" }, this.canvas, this.over, beside);
    this.key = s("svg", { class: key });
    this.element = h("div", { class: "view" }, this.stage, this.key);
    this.tooltip = new Tooltip(this.stage);
    new ResizeObserver(() => this.#resize()).observe(this.stage);
  }

  get theme() { return themeOf(this.state.get("theme")); }

  /** `more` are further answers of gestures(), or other ones. */
  listen(more = {}) {
    gestures(this.canvas, this.camera, {
      moved: () => this.soon(), hover: (place) => this.pick(place), leave: () => this.unpick(), reset: () => this.reset(), ...more,
    });
  }

  refresh(...parts) {
    for (const part of parts) this.stale.add(part);
    this.unpick();
    this.soon();
  }

  soon() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.draw();
    });
  }

  fit() { this.camera.fit(this.extent, this.margin); }

  reset() {
    this.fit();
    this.soon();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.stage;
    if (width === 0 || height === 0) return;
    const fitted = this.camera.fitted || !this.sized;
    this.sized = true;
    this.camera.resize(width, height);
    this.pixelRatio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.pixelRatio);
    this.canvas.height = Math.round(height * this.pixelRatio);
    if (fitted) this.fit();
    this.draw();
  }

  draw() {
    if (!this.sized) return;
    this.update(this.stale);
    this.stale.clear();
    this.paint();
    this.over.setAttribute("viewBox", `0 0 ${this.camera.width} ${this.camera.height}`);
    this.drawOverlay();
    this.key.setAttribute("viewBox", `0 0 ${this.camera.width} ${this.legendHeight}`);
    this.key.replaceChildren(this.legend());
  }

  unpick() {
    if (this.picked === null) return;
    this.picked = null;
    this.tooltip.hide();
    this.drawOverlay();
  }
}
