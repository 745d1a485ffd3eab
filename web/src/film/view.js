import { h, s } from "../dom.js";
import { gestures } from "../gestures.js";
import { Camera } from "../packing/camera.js";
import { Tooltip } from "../packing/tooltip.js";
import { fileName, savePng, saveSvg, svgText } from "../save.js";
import { themeOf } from "../theme.js";
import { legend, legendHeight } from "./legend.js";
import { barWidth, outline, overlay } from "./overlay.js";
import { painted } from "./paint.js";
import { contactNumbers, pixelNumbers } from "./tooltip.js";

const margin = 6, veil = 0.72, largePixel = 6;

/** The picture of a film: the map on a canvas, grains and forces over it as vectors, legend and what the pointer does. The
    camera looks on (column, -row). */
export class FilmView {
  constructor(film, state) {
    Object.assign(this, { film, state, camera: new Camera(), picked: null });
    this.canvas = h("canvas", { class: "film", tabindex: 0, "aria-label": "The film: wheel zooms, dragging moves, double click shows all" });
    this.lines = s("g");
    this.mark = s("g");
    this.over = s("svg", { class: "over" }, this.lines, this.mark);
    this.stage = h("div", { class: "stage" }, this.canvas, this.over);
    this.key = s("svg", { class: "key field-key" });
    this.element = h("div", { class: "view" }, this.stage, this.key);
    this.tooltip = new Tooltip(this.stage);
    gestures(this.canvas, this.camera, { moved: () => this.#soon(), hover: (place) => this.#pick(place), leave: () => this.#unpick(), reset: () => this.reset() });
    new ResizeObserver(() => this.#resize()).observe(this.stage);
    state.watch(["map", "law", "clip", "theme"], () => this.#refresh({ map: true }));
    state.watch(["grains", "forces", "motion", "theme"], () => this.#refresh({ lines: true }));
    this.stale = { map: true, lines: true };
  }

  get theme() { return themeOf(this.state.get("theme")); }
  get veil() { return this.state.get("grains") === "stress" ? veil : 0; }

  #refresh(parts) {
    Object.assign(this.stale, parts);
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
    Object.assign(this.canvas, { width: Math.round(width * this.pixelRatio), height: Math.round(height * this.pixelRatio) });
    if (fitted) this.camera.fit(this.film.box, margin);
    this.#draw();
  }

  #draw() {
    if (!this.sized) return;
    const { film, state, theme, camera } = this;
    if (this.stale.map) this.picture = painted(film, state, theme);
    if (this.stale.lines) this.lines.replaceChildren(overlay(film, state, theme));
    this.stale = {};
    this.#drawMap();
    this.over.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
    this.lines.setAttribute("transform", this.transform);
    this.#drawMark();
    this.key.setAttribute("viewBox", `0 0 ${camera.width} ${legendHeight}`);
    this.key.replaceChildren(legend(film, camera, theme, state, camera.width));
  }

  /** From the film's pixels to the screen's. */
  get transform() {
    const { camera } = this, [x, y] = camera.toScreen(0, 0);
    return `translate(${x} ${y}) scale(${camera.scale})`;
  }

  /** The film's rectangle on the screen. */
  get place() {
    const [x, y] = this.camera.toScreen(-0.5, 0.5);
    return { x, y, width: this.film.width * this.camera.scale, height: this.film.height * this.camera.scale };
  }

  #drawMap() {
    const context = this.canvas.getContext("2d"), { theme, pixelRatio: ratio } = this, { x, y, width, height } = this.place;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = theme.card;
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.imageSmoothingEnabled = this.camera.scale * ratio < 1;  // shrunk maps are averaged, large pixels stay squares
    context.imageSmoothingQuality = "high";
    context.globalAlpha = 1 - this.veil;
    context.drawImage(this.picture, x * ratio, y * ratio, width * ratio, height * ratio);
    context.globalAlpha = 1;
  }

  #drawMark() {
    this.mark.setAttribute("transform", this.transform);
    this.mark.replaceChildren(this.picked ? outline(this.film, this.picked, this.theme, this.camera.scale >= largePixel) : "");
  }

  reset() {
    this.camera.fit(this.film.box, margin);
    this.#soon();
  }

  #pick(place) {
    const [x, down] = this.camera.toWorld(...place), y = -down, { film, theme } = this;
    const pixel = film.pixelAt(x, y);
    if (pixel === null) return this.#unpick();
    const contact = this.state.get("forces") && film.hasForces ? this.#contactAt(x, y) : null;
    const grain = contact === null ? film.grainAt(x, y) : null;
    this.picked = { pixel: contact === null ? pixel : null, grain: this.state.get("grains") === "off" ? null : grain, contact };
    this.#drawMark();
    this.tooltip.write(contact === null ? pixelNumbers(film, pixel, grain, theme) : contactNumbers(film, contact, theme), place);
  }

  /** The contact whose bar lies under the point; the strongest one of several. */
  #contactAt(x, y) {
    const { fn } = this.film.contacts, reach = 2.5 / this.camera.scale;
    let found = null;
    for (let c = 0; c < fn.length; ++c) {
      if (found !== null && Math.abs(fn[c]) <= Math.abs(fn[found])) continue;
      if (distance(this.film.endsOf(c), x, y) <= Math.max(reach, barWidth(this.film, fn[c]) / 2)) found = c;
    }
    return found;
  }

  #unpick() {
    if (!this.picked) return;
    this.picked = null;
    this.tooltip.hide();
    this.#drawMark();
  }

  get name() { return fileName(this.film.title, this.film.name, this.state.get("map")); }

  /** All that is seen, as vectors with the map inside. */
  svg() {
    const { camera, film, theme, state } = this, { width, height } = camera, whole = height + legendHeight + 4;
    return s("svg", { xmlns: "http://www.w3.org/2000/svg", width, height: whole, viewBox: `0 0 ${width} ${whole}` },
      s("defs", {}, s("clipPath", { id: "seen" }, s("rect", { width, height }))),
      s("g", { "clip-path": "url(#seen)" },
        s("image", { href: this.picture.toDataURL("image/png"), ...this.place, preserveAspectRatio: "none", opacity: 1 - this.veil, style: "image-rendering: pixelated" }),
        s("g", { transform: this.transform }, overlay(film, state, theme))),
      s("g", { transform: `translate(0 ${height + 4})` }, legend(film, camera, theme, state, width)));
  }

  saveSvg() { saveSvg(this.name, this.svg(), this.theme); }

  savePng() {
    const svg = this.svg(), { width, height } = svg.viewBox.baseVal;
    return savePng(this.name, svgText(svg, this.theme), width, height, Math.max(2, this.pixelRatio));
  }
}

function distance([ax, ay, bx, by], x, y) {
  const dx = bx - ax, dy = by - ay;
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
