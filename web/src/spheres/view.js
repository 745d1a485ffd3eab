import { s } from "../dom.js";
import { fileName } from "../save.js";
import { axes } from "../space/frame.js";
import { outline } from "../space/outline.js";
import { SpaceView } from "../space/view.js";
import { bondsOf, together } from "./bonds.js";
import { edgesOf } from "./boundaries.js";
import { coloursOfLines, linesOf } from "./chains.js";
import { legend, legendHeight } from "./legend.js";
import { coloursOf, painted } from "./paint.js";
import { SphereScene } from "./scene.js";
import { seenSphere } from "./seen.js";
import { sphereNumbers } from "./tooltip.js";

const without = "This browser has no WebGL2, which the picture in space needs; the figures show the same state.";
const fog = 0.5; // opacity of all spheres behind one another while forces are shown

/** The spheres as they are seen from a side, without those whose centres lie beyond the cuts. */
export class SphereView extends SpaceView {
  constructor(result, state) {
    super(state, {
      name: "spheres",
      label: "The spheres in space",
      without,
      margin: 6,
      key: "key sphere-key",
      legendHeight,
      parts: ["balls", "colours", "lines"],
      makeScene: (canvas) => SphereScene.on(canvas),
    });
    this.result = result;
    result.show(state.get("snapshot"));
    state.watch(["snapshot"], () => this.showState());
    state.watch(["half"], () => this.#tellLook());
    state.watch(painted, () => this.refresh("colours", "lines"));
    state.watch(["selected", "pointed"], () => this.sized && this.drawOverlay());
    state.watch(["chains", "bonds", "boundaries", "spheres"], () => this.refresh("lines"));
  }

  /** Another state, or another result in the place of the first. */
  showState(result = this.result) {
    this.result = result;
    result.show(this.state.get("snapshot"));
    Object.assign(this, { forces: null, bonds: null, edges: null, furthest: null });
    this.refresh("balls", "colours", "lines");
  }

  get size() {
    return this.result.size;
  }
  get extent() {
    const r = this.result.reach;
    return { left: -r, right: r, bottom: -r, top: r };
  }
  get upright() {
    return 1;
  }
  get spacing() {
    return 1;
  }
  /** Along each axis, from the middle. */
  get kept() {
    return axes.map((axis, a) => this.result.place(a, this.state.get(`cut${axis}`)));
  }
  /** Spheres may lie somewhat outside of their container. */
  get reach() {
    return (this.furthest ??= furthestOf(this.result) + this.result.reach);
  }
  /** Lines between spheres, which are seen through them. */
  get hasLinesWithin() {
    return this.state.get("chains") || this.state.get("bonds");
  }
  get hasLines() {
    return this.hasLinesWithin || this.state.get("boundaries");
  }
  get pale() {
    if (!this.state.get("spheres")) return 0;
    return this.hasLinesWithin ? fog / Math.cbrt(Math.max(1, this.result.count)) : 1;
  }

  update(stale) {
    const { scene, result, state, theme } = this;
    if (stale.size > 0) this.keptLegend = null;
    if (!scene) return;
    if (stale.has("balls")) {
      scene.spheres.set("ball", result.state.balls);
      scene.spheres.count = result.count;
    }
    if (stale.has("colours")) scene.spheres.set("colour", coloursOf(result, state, theme));
    if (stale.has("lines") && this.hasLines) this.#setLines();
  }

  /** For a figure that turns as the picture does. */
  #tellLook() {
    const { azimuth, elevation } = this.look;
    if (this.state.get("half") === "turned") this.state.set({ turned: `${azimuth} ${elevation}` });
  }

  #setLines() {
    const { result, state } = this,
      { lines } = this.scene,
      shown = [];
    if (state.get("chains")) shown.push((this.forces ??= linesOf(result)));
    if (state.get("bonds")) shown.push((this.bonds ??= bondsOf(result)));
    if (state.get("boundaries")) shown.push((this.edges ??= edgesOf(result)));
    const all = together(shown);
    lines.set("ends", all.ends);
    lines.set("radius", all.radius);
    lines.set("colour", coloursOfLines(all, this.theme));
    lines.count = all.kind.length;
  }

  paint(pixelRatio = this.pixelRatio) {
    const { camera, theme } = this;
    this.#tellLook();
    this.scene?.draw({
      frame: this.frame,
      kept: this.kept,
      scale: camera.scale * pixelRatio,
      middle: [camera.x, camera.y],
      reach: this.reach,
      card: theme.card,
      glow: theme.name === "dark" ? 0.12 : 0,
      lineGlow: theme.name === "dark" ? 0 : 0.45,
      pale: this.pale,
      withLines: this.hasLines,
    });
  }

  outline() {
    const { shift } = this.result.state,
      kept = this.size.map((side, a) => Math.min(side, this.kept[a] - shift[a] + side / 2)),
      toScreen = (point) => this.toScreen(point.map((place, a) => place + shift[a]));
    return outline(this.frame, this.size, kept, null, toScreen, this.theme, this.upright);
  }

  drawOverlay() {
    super.drawOverlay();
    if (!this.scene) return;
    const { theme, state } = this,
      selected = state.get("selected"),
      pointed = this.picked ?? state.get("pointed");
    if (selected !== null)
      this.over.append(this.#ring(selected, theme.card, 5), this.#ring(selected, theme.accent, 3, "selected"));
    if (pointed !== null) this.over.append(this.#ring(pointed, theme.ink, 2));
  }

  /** Around a sphere, also where others hide it. */
  #ring(sphere, stroke, width, name = null) {
    const [x, y, z, r] = this.result.state.balls.subarray(4 * sphere),
      [cx, cy] = this.toScreen([x, y, z]);
    return s("circle", { cx, cy, r: r * this.camera.scale, fill: "none", stroke, "stroke-width": width, class: name });
  }

  newLegend(less = 0) {
    return legend(this.result, this.state, this.theme, this.camera.width - less, this.scene && this.camera);
  }

  /** The sphere that is seen at a place of the picture, or null. */
  sphereAt(place) {
    if (!this.state.get("spheres")) return null;
    return seenSphere(this.frame, this.camera.toWorld(...place), this.result.state.balls, this.kept);
  }

  pick(place) {
    const sphere = this.sphereAt(place);
    if (sphere === null) return this.unpick();
    const isNew = this.picked !== sphere;
    this.picked = sphere;
    if (isNew) this.drawOverlay();
    this.tooltip.write(sphereNumbers(this.result, sphere, this.theme), place);
  }

  /** A click marks a sphere in table and charts, too; one on it, or beside all, takes that away. */
  click(place) {
    const sphere = this.sphereAt(place);
    this.state.set({ selected: sphere === this.state.get("selected") ? null : sphere });
  }

  get name() {
    return fileName(this.result.title, this.result.name, this.state.get("show"));
  }
}

function furthestOf({ count, state: { balls } }) {
  let most = 0;
  for (let g = 0; g < count; ++g)
    most = Math.max(most, Math.hypot(balls[4 * g], balls[4 * g + 1], balls[4 * g + 2]) + balls[4 * g + 3]);
  return most;
}
