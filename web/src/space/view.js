import { forms } from "../address.js";
import { CanvasView } from "../canvas_view.js";
import { h, s } from "../dom.js";
import { drawn } from "../drawn.js";
import { saveSvg } from "../save.js";
import { along, axes, frameOf } from "./frame.js";
import { degreesAPixel, turning } from "./turning.js";

const howToTurn =
  "drag to turn it, Shift and drag to move it, Ctrl+wheel or pinch to zoom, double-click to show all; keys: arrows, " +
  "+, \u2212 and 0";
/** From where the sample is seen in the beginning. */
export const firstLook = () => ({ ...drawn().look, zoom: 1 });
const turned = ["azimuth", "elevation", "zoom"];
const pause = 200; // ms after the last turn until the address and finer lines of sight follow
const saveMargin = 10; // px, for what stands out of the legend
const nearest = 40,
  farthest = 0.5;

/** How the address keeps it. */
export const lookForms = {
  azimuth: forms.between(0, 360),
  elevation: forms.between(-90, 90),
  zoom: forms.between(farthest, nearest),
};

const within = (value, least, most) => Math.min(most, Math.max(least, value));

/** A sample in space as it is seen from a side, in parallel projection. Whoever extends it gives, beside what a
    CanvasView asks for, `size` (sides of the box), `spacing` (metres of one of them), `upright` (an axis, unless z),
    `outline()` (SVG over the picture), `newLegend(less)` (narrower by so many pixels), `name` (of saved files) and
    `click(place)`; and here what makes its scene, null without WebGL2, which the sentence `without` then says. */
export class SpaceView extends CanvasView {
  constructor(state, { label, without, makeScene, ...rest }) {
    super(state, { label, ...rest });
    this.canvas.setAttribute("aria-label", `${label}: ${howToTurn}`);
    this.look = Object.fromEntries(turned.map((key) => [key, state.get(key)]));
    this.scene = makeScene(this.canvas);
    this.followCamera = () => {};
    if (this.scene) this.#listen();
    else this.#sayWhy(without);
    state.watch(
      axes.map((a) => `cut${a}`),
      () => this.refresh(),
    );
    state.watch(turned, () => {
      if (turned.every((key) => this.look[key] === state.get(key))) return;
      this.look = Object.fromEntries(turned.map((key) => [key, state.get(key)]));
      this.#zoomTo(this.look.zoom);
      this.refresh();
    });
  }

  #sayWhy(words) {
    this.canvas.hidden = true;
    this.stage.append(h("p", { class: "nothing" }, words));
  }

  #listen() {
    turning(this.canvas, {
      turn: (dx, dy) => {
        const { azimuth, elevation } = this.look;
        this.#turnTo({
          azimuth: (((azimuth - degreesAPixel * dx) % 360) + 360) % 360,
          elevation: within(elevation + degreesAPixel * dy, -90, 90),
        });
      },
      move: (dx, dy) => {
        this.camera.x -= dx / this.camera.scale;
        this.camera.y += dy / this.camera.scale;
        this.#turnTo({});
      },
      zoom: (factor, place) => this.#zoomAt(factor, place),
      hover: (place) => this.pick(place),
      leave: () => this.unpick(),
      click: (place) => this.click(place),
      reset: () => {
        this.camera.fit(this.extent, this.margin);
        this.#turnTo(firstLook());
      },
      scrolled: () => this.sayHow(),
    });
  }

  click() {}
  get upright() {
    return 2;
  }

  /** Half of the longest diagonal, so that the sample stays in sight however it is turned. */
  get extent() {
    const r = (Math.hypot(...this.size) * this.spacing) / 2;
    return { left: -r, right: r, bottom: -r, top: r };
  }
  get frame() {
    return frameOf(this.look.azimuth, this.look.elevation, this.upright);
  }

  fit() {
    super.fit();
    if (!this.scene) this.stage.style.setProperty("--shape", 6);
    this.#zoomTo(this.look.zoom);
    this.soon();
  }

  #zoomTo(zoom) {
    this.camera.scale = this.camera.whole.scale * zoom;
  }

  #zoomAt(factor, place) {
    const { camera } = this,
      zoom = within(this.look.zoom * factor, farthest, nearest),
      [x, y] = camera.toWorld(...place);
    this.#zoomTo(zoom);
    const [nowX, nowY] = camera.toWorld(...place);
    camera.x += x - nowX;
    camera.y += y - nowY;
    this.#turnTo({ zoom });
  }

  #turnTo(changes) {
    Object.assign(this.look, changes);
    this.soon();
  }

  /** Coarse while anything changes. Once it rests, lines of sight are finer and the address follows, whose changes
      browsers bound. */
  soon() {
    this.rests = false;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => {
      this.rests = true;
      this.#keepLook();
      super.soon();
    }, pause);
    super.soon();
  }

  #keepLook() {
    const { azimuth, elevation, zoom } = this.look,
      rounded = (value, digits) => Number(value.toFixed(digits));
    this.look = { azimuth: rounded(azimuth, 1) % 360, elevation: rounded(elevation, 1), zoom: rounded(zoom, 2) };
    this.state.set(this.look);
  }

  /** A point of space, in sides' units from the middle, in the picture. */
  toScreen = (point) => this.camera.toScreen(...along(this.frame, point).map((value) => value * this.spacing));

  drawOverlay() {
    this.over.replaceChildren(...(this.scene ? [this.outline()] : []));
  }

  legend() {
    const { width, scale } = this.camera,
      key = `${width} ${scale}`;
    if (!this.keptLegend || this.legendKey !== key) {
      this.legendKey = key;
      this.keptLegend = this.newLegend();
    }
    return this.keptLegend;
  }

  #legendBelow() {
    const place = `translate(${saveMargin} ${this.camera.height + 4})`;
    return s("g", { transform: place }, this.newLegend(2 * saveMargin));
  }

  savePng() {
    const whole = this.camera.height + this.legendHeight + 4;
    return this.savePainted(this.name, whole, this.outline(), this.#legendBelow());
  }

  saveSvg() {
    const { width, height } = this.camera,
      whole = height + this.legendHeight + 4;
    this.paint();
    const svg = s(
      "svg",
      { width, height: whole, viewBox: `0 0 ${width} ${whole}` },
      s("image", { href: this.canvas.toDataURL("image/png"), x: 0, y: 0, width, height }),
      this.outline(),
      this.#legendBelow(),
    );
    saveSvg(this.name, svg, this.theme);
  }
}
