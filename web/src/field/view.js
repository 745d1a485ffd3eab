import { h, s } from "../dom.js";
import { gestures } from "../gestures.js";
import { Camera } from "../packing/camera.js";
import { Tooltip } from "../packing/tooltip.js";
import { themeOf } from "../theme.js";
import { closeUp } from "./close_up.js";
import { brokenAt, crackBuffers } from "./cracks.js";
import { barBuffers, crossesInGrain, crossesOf } from "./crosses.js";
import { legend, legendHeight } from "./legend.js";
import { paint } from "./paint.js";
import { FieldScene } from "./scene.js";
import { nodeNumbers } from "./tooltip.js";

const margin = 8;
const painted = ["show", "component", "around", "law", "clip", "by", "chains", "threshold", "cavities", "theme"];

/** The picture of a raster: canvas, overlay, legend and what the pointer does on them. */
export class FieldView {
  constructor(result, state) {
    Object.assign(this, { result, state, camera: new Camera(), stale: new Set(["paint", "crosses", "cracks"]), picked: null });
    this.canvas = h("canvas", { class: "nodes", tabindex: 0, "aria-label": "The sample: wheel zooms, dragging moves, a click shows a grain close up, double click shows all" });
    this.over = s("svg", { class: "over" });
    this.stage = h("div", { class: "stage" }, this.canvas, this.over, closeUp(result, state));
    this.key = s("svg", { class: "key field-key" });
    this.element = h("div", { class: "view" }, this.stage, this.key);
    this.tooltip = new Tooltip(this.stage);
    this.scene = new FieldScene(this.canvas, result.map);
    gestures(this.canvas, this.camera, {
      moved: () => this.#soon(), hover: (place) => this.#pick(place), leave: () => this.#unpick(),
      click: (place) => this.#choose(place), reset: () => state.get("grain") ? state.set({ grain: 0 }) : this.reset(),
    });
    new ResizeObserver(() => this.#resize()).observe(this.stage);
    state.watch(painted, () => this.#refresh("paint"));
    state.watch(["crosses", "theme"], () => this.#refresh("crosses"));
    state.watch(["step", "cracks", "theme"], () => this.#refresh("cracks"));
    state.watch(["outlines"], () => this.#refresh());
    state.watch(["grain"], () => {
      this.#look();
      this.#refresh("crosses");
    });
  }

  get theme() { return themeOf(this.state.get("theme")); }
  get broken() { return this.state.get("cracks") ? brokenAt(this.result, this.state.get("step")) : 0; }
  get look() {
    const { state } = this;
    const veiled = this.result.cracks && state.get("cracks") && state.get("show") !== "field";
    return { outline: state.get("outlines"), chosen: state.get("grain"), fade: veiled ? 0.45 : 0 };
  }

  bars() {
    const { result, state } = this, grain = state.get("grain");
    if (!state.get("crosses") || !result.loaded) return [];
    return grain ? crossesInGrain(result, this.theme, grain - 1) : crossesOf(result, this.theme);
  }

  #refresh(...parts) {
    for (const part of parts) this.stale.add(part);
    this.#unpick();
    this.#soon();
  }

  #soon() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.#draw();
    });
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
    if (fitted) this.camera.fit(this.result.map.box, margin);
    this.#draw();
  }

  /** A chosen grain fills the picture; without one the whole sample is shown. */
  #look() {
    const grain = this.state.get("grain");
    this.camera.fit(this.result.map.box, margin);
    if (!grain) return;
    const least = this.camera.least;
    this.camera.fit(this.result.boxOfGrain(grain - 1), 0.16 * Math.min(this.camera.width, this.camera.height));
    this.camera.least = least;
  }

  #draw() {
    if (!this.sized) return;
    const { result, scene, state, theme, camera, broken } = this;
    if (this.stale.has("paint")) scene.setPaint(paint(result, state, theme));
    if (this.stale.has("crosses")) scene.setLayer("crosses", barBuffers(this.bars(), scene.origin));
    if (this.stale.has("cracks")) scene.setLayer("cracks", broken ? crackBuffers(result, broken, theme, scene.origin) : { count: 0 });
    this.stale.clear();
    scene.draw(camera, this.pixelRatio, theme, this.look);
    this.#outline();
    this.key.setAttribute("viewBox", `0 0 ${camera.width} ${legendHeight}`);
    this.key.replaceChildren(legend(result, camera, theme, state, camera.width, broken));
  }

  /** A square around the node under the pointer once nodes can be told apart. */
  #outline() {
    this.over.setAttribute("viewBox", `0 0 ${this.camera.width} ${this.camera.height}`);
    const size = this.result.map.spacing * this.camera.scale;
    if (this.picked === null || size < 4) return this.over.replaceChildren();
    const [x, y] = this.camera.toScreen(...this.result.map.placeOf(this.picked));
    this.over.replaceChildren(s("rect", { x: x - size / 2, y: y - size / 2, width: size, height: size, fill: "none", stroke: this.theme.ink, "stroke-width": 1.5 }));
  }

  reset() {
    this.camera.fit(this.result.map.box, margin);
    this.#soon();
  }

  #node([px, py]) { return this.result.map.nodeAt(...this.camera.toWorld(px, py)); }

  #choose(place) {
    const node = this.#node(place);
    const label = node === null ? 0 : this.result.map.label[node];
    if (label && label !== this.state.get("grain")) this.state.set({ grain: label });
  }

  #pick(place) {
    const node = this.#node(place);
    if (node === null) return this.#unpick();
    this.picked = node;
    this.#outline();
    this.tooltip.write(nodeNumbers(this.result, node, this.theme, this.state.get("show")), place);
  }

  #unpick() {
    if (this.picked === null) return;
    this.picked = null;
    this.tooltip.hide();
    this.#outline();
  }
}
