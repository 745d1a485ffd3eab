import { h, s } from "../dom.js";
import { gestures } from "../gestures.js";
import { fileName, savePng, saveSvg } from "../save.js";
import { themeOf } from "../theme.js";
import { Camera } from "./camera.js";
import { legend, legendHeight } from "./legend.js";
import { overlay } from "./overlay.js";
import { Picker } from "./picking.js";
import { mostVectors, packingSvg } from "./picture.js";
import { Scene } from "./scene.js";
import { Tooltip } from "./tooltip.js";

const margin = 26;

/** The picture of the packing: canvas, overlay, legend and what the pointer does on them. */
export class PackingView {
  constructor(sample, state) {
    Object.assign(this, { sample, state, camera: new Camera(), stale: new Set(["positions", "colours", "chains"]), picked: null });
    this.canvas = h("canvas", { class: "grains", tabindex: 0, "aria-label": "The packing: wheel zooms, dragging moves, double click shows all" });
    this.over = s("svg", { class: "over" });
    this.stage = h("div", { class: "stage" }, this.canvas, this.over);
    this.key = s("svg", { class: "key" });
    this.element = h("div", { class: "view" }, this.stage, this.key);
    this.tooltip = new Tooltip(this.stage);
    this.scene = new Scene(this.canvas, sample);
    this.#listen();
    new ResizeObserver(() => this.#resize()).observe(this.stage);
    state.watch(["frame"], () => this.#refresh("positions", "colours", "chains"));
    state.watch(["colour"], () => this.#refresh("colours"));
    state.watch(["theme"], () => this.#refresh("colours", "chains"));
    state.watch(["chains", "types", "strength", "marks"], () => this.#refresh("chains"));
  }

  get frame() { return this.sample.frame(this.state.get("frame")); }
  get theme() { return themeOf(this.state.get("theme")); }

  #refresh(...parts) {
    for (const part of parts) this.stale.add(part);
    if (parts.includes("positions")) {
      this.picker = null;
      if (this.camera.fitted) this.camera.fit(this.#extent(), margin);
    }
    this.#unpick();
    this.#soon();
  }

  #soon() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.#draw();
    });
  }

  /** One box for all frames, so that the picture stands still while a wall moves. */
  #extent() {
    if (this.extent) return this.extent;
    const boxes = this.sample.about.frames.map((frame) => this.sample.box(frame));
    return (this.extent = {
      left: Math.min(...boxes.map((b) => b.left)), right: Math.max(...boxes.map((b) => b.right)),
      bottom: Math.min(...boxes.map((b) => b.bottom)), top: Math.max(...boxes.map((b) => b.top)),
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
    if (fitted) this.camera.fit(this.#extent(), margin);
    this.#draw();
  }

  #draw() {
    if (!this.sized) return;
    const { frame, theme, state } = this;
    if (this.stale.has("positions")) this.scene.updatePositions(frame);
    if (this.stale.has("colours")) this.scene.updateColours(frame, state.get("colour"), theme);
    if (this.stale.has("chains")) this.scene.updateChains(state, frame, theme);
    this.stale.clear();
    this.scene.draw(this.camera, this.pixelRatio, theme, state);
    this.#drawOverlay();
    this.key.setAttribute("viewBox", `0 0 ${this.camera.width} ${legendHeight}`);
    this.key.replaceChildren(legend(this.sample, frame, this.camera, theme, state, this.camera.width));
  }

  #drawOverlay() {
    this.over.setAttribute("viewBox", `0 0 ${this.camera.width} ${this.camera.height}`);
    this.over.replaceChildren(overlay(this.sample, this.frame, this.camera, this.theme, { walls: true, picked: this.picked }));
  }

  #listen() {
    gestures(this.canvas, this.camera, {
      moved: () => this.#soon(), hover: (place) => this.#pick(place), leave: () => this.#unpick(), reset: () => this.reset(),
    });
  }

  reset() {
    this.camera.fit(this.#extent(), margin);
    this.#soon();
  }

  #pick([px, py]) {
    this.picker ??= new Picker(this.sample, this.frame);
    const [x, y] = this.camera.toWorld(px, py);
    const contact = this.state.get("chains") ? this.picker.contact(x, y, 2.5 / this.camera.scale, this.state) : null;
    const grain = contact === null ? this.picker.grain(x, y) : null;
    if (contact === null && grain === null) return this.#unpick();
    this.picked = contact !== null ? { contact } : { grain };
    this.#drawOverlay();
    this.tooltip.show(this.picked, this.sample, this.frame, this.theme, [px, py]);
  }

  #unpick() {
    if (!this.picked) return;
    this.picked = null;
    this.tooltip.hide();
    this.#drawOverlay();
  }

  get name() { return fileName(this.sample.title, "packing", this.state.get("colour")); }

  get vectors() { return this.sample.count + (this.state.get("chains") ? this.frame.contacts.fn.length : 0); }
  get fewEnoughForSvg() { return this.vectors < mostVectors; }

  saveSvg() {
    const svg = packingSvg(this.sample, this.frame, this.camera, this.theme, this.state);
    saveSvg(this.name, svg, this.theme);
  }

  /** Twice as fine as the screen at least: the canvas is painted once more at that size. */
  async savePng() {
    const { camera, theme, state } = this;
    const ratio = Math.max(2, this.pixelRatio), height = camera.height + legendHeight + 8;
    const size = [this.canvas.width, this.canvas.height];
    Object.assign(this.canvas, { width: Math.round(camera.width * ratio), height: Math.round(camera.height * ratio) });
    this.scene.draw(camera, ratio, theme, state);
    const over = s("svg", { xmlns: "http://www.w3.org/2000/svg", width: camera.width, height, viewBox: `0 0 ${camera.width} ${height}` },
      overlay(this.sample, this.frame, camera, theme, { walls: true }),
      s("g", { transform: `translate(0 ${camera.height + 4})` }, legend(this.sample, this.frame, camera, theme, state, camera.width)));
    await savePng(this.name, new XMLSerializer().serializeToString(over), camera.width, height, ratio, (context) => {
      context.fillStyle = theme.card;
      context.fillRect(0, 0, context.canvas.width, context.canvas.height);
      context.drawImage(this.canvas, 0, 0);
      [this.canvas.width, this.canvas.height] = size;
    });
    this.#draw();
  }
}
