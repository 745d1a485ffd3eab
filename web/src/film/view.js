import { CanvasView } from "../canvas_view.js";
import { s } from "../dom.js";
import { fileName, savePng, saveSvg, svgText } from "../save.js";
import { distanceToSegment } from "../segment.js";
import { legend, legendHeight } from "./legend.js";
import { barWidth, outline, overlay } from "./overlay.js";
import { painted } from "./paint.js";
import { contactNumbers, pixelNumbers } from "./tooltip.js";

const label = "The film";
const veil = 0.72,
  largePixel = 6;

/** The picture of a film: the map on a canvas, grains and forces over it as vectors, legend and what the pointer does.
    The camera looks on (column, -row). */
export class FilmView extends CanvasView {
  constructor(film, state) {
    super(state, { name: "film", label, margin: 6, key: "key field-key", legendHeight, parts: ["map", "lines"] });
    this.film = film;
    this.lines = s("g");
    this.mark = s("g");
    this.over.append(this.lines, this.mark);
    this.listen();
    state.watch(["map", "law", "clip", "theme"], () => this.refresh("map"));
    state.watch(["grains", "forces", "motion", "theme"], () => this.refresh("lines"));
  }

  get extent() {
    return this.film.box;
  }
  get veil() {
    return this.state.get("grains") === "stress" ? veil : 0;
  }

  update(stale) {
    const { film, state, theme } = this;
    if (stale.has("map")) this.picture = painted(film, state, theme);
    if (stale.has("lines")) this.lines.replaceChildren(overlay(film, state, theme));
  }

  legend() {
    return legend(this.film, this.camera, this.theme, this.state, this.camera.width);
  }

  /** From the film's pixels to the screen's. */
  get transform() {
    const { camera } = this,
      [x, y] = camera.toScreen(0, 0);
    return `translate(${x} ${y}) scale(${camera.scale})`;
  }

  /** The film's rectangle on the screen. */
  get place() {
    const [x, y] = this.camera.toScreen(-0.5, 0.5);
    return { x, y, width: this.film.width * this.camera.scale, height: this.film.height * this.camera.scale };
  }

  paint() {
    const context = this.canvas.getContext("2d"),
      { theme, pixelRatio: ratio } = this,
      { x, y, width, height } = this.place;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = theme.card;
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    // Shrunk maps are averaged, large pixels stay squares.
    context.imageSmoothingEnabled = this.camera.scale * ratio < 1;
    context.imageSmoothingQuality = "high";
    context.globalAlpha = 1 - this.veil;
    context.drawImage(this.picture, x * ratio, y * ratio, width * ratio, height * ratio);
    context.globalAlpha = 1;
  }

  drawOverlay() {
    for (const layer of [this.lines, this.mark]) layer.setAttribute("transform", this.transform);
    this.mark.replaceChildren(
      this.picked ? outline(this.film, this.picked, this.theme, this.camera.scale >= largePixel) : "",
    );
  }

  pick(place) {
    const [x, down] = this.camera.toWorld(...place),
      y = -down,
      { film, theme } = this;
    const pixel = film.pixelAt(x, y);
    if (pixel === null) return this.unpick();
    const contact = this.state.get("forces") && film.hasForces ? this.#contactAt(x, y) : null;
    const grain = contact === null ? film.grainAt(x, y) : null;
    this.picked = {
      pixel: contact === null ? pixel : null,
      grain: this.state.get("grains") === "off" ? null : grain,
      contact,
    };
    this.drawOverlay();
    this.tooltip.write(
      contact === null ? pixelNumbers(film, pixel, grain, theme) : contactNumbers(film, contact, theme),
      place,
    );
  }

  /** The contact whose bar lies under the point; the strongest one of several. */
  #contactAt(x, y) {
    const { fn } = this.film.contacts,
      reach = 2.5 / this.camera.scale;
    let found = null;
    for (let c = 0; c < fn.length; ++c) {
      if (found !== null && Math.abs(fn[c]) <= Math.abs(fn[found])) continue;
      if (distanceToSegment(this.film.endsOf(c), x, y) <= Math.max(reach, barWidth(this.film, fn[c]) / 2)) found = c;
    }
    return found;
  }

  get name() {
    return fileName(this.film.title, this.film.name, this.state.get("map"));
  }

  /** All that is seen, as vectors with the map inside. */
  svg() {
    const { camera, film, theme, state } = this,
      { width, height } = camera,
      whole = height + legendHeight + 4;
    return s(
      "svg",
      { xmlns: "http://www.w3.org/2000/svg", width, height: whole, viewBox: `0 0 ${width} ${whole}` },
      s("defs", {}, s("clipPath", { id: "seen" }, s("rect", { width, height }))),
      s(
        "g",
        { "clip-path": "url(#seen)" },
        s("image", {
          href: this.picture.toDataURL("image/png"),
          ...this.place,
          preserveAspectRatio: "none",
          opacity: 1 - this.veil,
          style: "image-rendering: pixelated",
        }),
        s("g", { transform: this.transform }, overlay(film, state, theme)),
      ),
      s("g", { transform: `translate(0 ${height + 4})` }, legend(film, camera, theme, state, width)),
    );
  }

  saveSvg() {
    saveSvg(this.name, this.svg(), this.theme);
  }

  savePng() {
    const svg = this.svg(),
      { width, height } = svg.viewBox.baseVal;
    return savePng(this.name, svgText(svg, this.theme), width, height, Math.max(2, this.pixelRatio));
  }
}
