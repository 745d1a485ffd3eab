import { h, s } from "./dom.js";
import { gestures } from "./gestures.js";
import { Camera } from "./camera.js";
import { savePng } from "./save.js";
import { Tooltip } from "./tooltip.js";
import { themeOf } from "./theme.js";

const key = navigator.platform.startsWith("Mac") ? "\u2318" : "Ctrl";
const gestureWords =
  `${key}+wheel or pinch to zoom, drag to pan, double-click to show all; ` + "keys: +, \u2212, 0 and arrows";
const hintWords = matchMedia("(hover: none)").matches
  ? "Two fingers move and zoom the picture"
  : `${key} + wheel zooms the picture; the wheel alone scrolls the page`;
const hintTime = 1600; // ms
const flattest = 2.4,
  highest = 0.8; // pictures, width over height

/** A picture seen through a camera: canvas, overlay and legend, drawn at most once a frame after something has changed.
    Whoever extends it gives `extent` (the box that is seen as a whole), `update(stale)` (the parts of the scene that
    have changed), `paint()` (at another ratio of pixels for `savePainted`), `drawOverlay()`, `legend()` and
    `pick(place)`, which sets `picked` to what lies under the pointer. */
export class CanvasView {
  constructor(state, { name, label, margin, key = "key", legendHeight, parts, beside = [] }) {
    Object.assign(this, { state, margin, legendHeight, camera: new Camera(), stale: new Set(parts), picked: null });
    this.canvas = h("canvas", { class: name, tabindex: 0, role: "img", "aria-label": `${label}: ${gestureWords}` });
    this.over = s("svg", { class: "over" });
    this.hint = h("p", { class: "hint", role: "status" }, hintWords);
    this.stage = h("div", { class: "stage" }, this.canvas, this.over, this.hint, beside);
    this.key = s("svg", { class: key });
    this.element = h("div", { class: "view" }, this.stage, this.key);
    this.tooltip = new Tooltip(this.stage);
    new ResizeObserver(() => window.matchMedia("print").matches || this.#resize()).observe(this.stage);
    window.addEventListener("beforeprint", () => this.draw()); // no frame passes before the page is laid out for paper
  }

  get theme() {
    return themeOf(this.state.get("theme"));
  }

  /** `more` are further answers of gestures(), or other ones. */
  listen(more = {}) {
    this.followCamera = gestures(this.canvas, this.camera, {
      moved: () => this.soon(),
      hover: (place) => this.pick(place),
      leave: () => this.unpick(),
      reset: () => this.reset(),
      scrolled: () => this.sayHow(),
      ...more,
    });
  }

  /** Who scrolls the page over the picture may have wanted to zoom. */
  sayHow() {
    this.hint.classList.add("shown");
    clearTimeout(this.hiding);
    this.hiding = setTimeout(() => this.hint.classList.remove("shown"), hintTime);
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

  /** All that is to be seen; the picture is as flat or high as that, within bounds. */
  fit() {
    const { left, right, bottom, top } = this.extent,
      shape = Math.min(flattest, Math.max(highest, (right - left) / (top - bottom)));
    this.stage.style.setProperty("--shape", shape.toFixed(2));
    this.camera.fit(this.extent, this.margin);
    this.followCamera();
  }

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
    else this.followCamera();
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

  /** Saves the canvas as PNG with SVG elements over it, `height` high in all and twice as fine as the screen at least:
      it is painted once more at that size. */
  async savePainted(name, height, ...over) {
    const {
        camera: { width, height: painted },
        canvas,
        pixelRatio,
        theme,
      } = this,
      ratio = Math.max(2, pixelRatio);
    const size = [canvas.width, canvas.height];
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(painted * ratio) });
    this.paint(ratio);
    const svg = s(
      "svg",
      { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}` },
      over,
    );
    await savePng(name, new XMLSerializer().serializeToString(svg), width, height, ratio, (context) => {
      context.fillStyle = theme.card;
      context.fillRect(0, 0, context.canvas.width, context.canvas.height);
      context.drawImage(canvas, 0, 0);
      [canvas.width, canvas.height] = size;
    });
    this.paint();
  }

  unpick() {
    if (this.picked === null) return;
    this.picked = null;
    this.tooltip.hide();
    this.drawOverlay();
  }
}
