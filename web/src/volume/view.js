import { CanvasView } from "../canvas_view.js";
import { h, s } from "../dom.js";
import { fileName, saveSvg } from "../save.js";
import { legend, legendHeight } from "./legend.js";
import { along, outline } from "./outline.js";
import { indexOf, painted, tableOf } from "./paint.js";
import { frameOf, seenCell } from "./ray.js";
import { axes } from "./result.js";
import { filling, VolumeScene } from "./scene.js";
import { voxelNumbers } from "./tooltip.js";
import { degreesAPixel, turning } from "./turning.js";

const label =
  "The sample in space: drag to turn it, Shift and drag to move it, Ctrl+wheel or pinch to zoom, double-click to " +
  "show all; keys: arrows, +, \u2212 and 0; a click leads the slices to what is seen there";
const noPicture = "This browser has no WebGL2, which the picture in space needs; the slices show the same values.";
/** From where the sample is seen in the beginning. */
export const firstLook = { azimuth: 35, elevation: 25, zoom: 1 };
const turned = Object.keys(firstLook);
const pause = 200; // ms after the last turn until the address and finer lines of sight follow
const saveMargin = 10; // px, for what stands out of the legend
const nearest = 40,
  farthest = 0.5;

const within = (value, least, most) => Math.min(most, Math.max(least, value));

/** The sample as it is seen from a side: what is cut away and phases that are switched off are transparent. */
export class VolumeView extends CanvasView {
  constructor(result, state) {
    super(state, {
      name: "volume",
      label,
      margin: 6,
      key: "key volume-key",
      legendHeight,
      parts: ["index", "table", "solid"],
    });
    this.canvas.setAttribute("aria-label", label);
    this.result = result;
    this.look = Object.fromEntries(turned.map((key) => [key, state.get(key)]));
    this.scene = VolumeScene.on(this.canvas, result.size);
    this.followCamera = () => {};
    if (!this.scene) this.#sayWhy();
    this.#listen();
    state.watch(painted, () => this.refresh("index", "table"));
    state.watch(["matrix", "particle", "level"], () => this.refresh("solid"));
    state.watch(["show", "component"], () => state.get("level") > 0 && this.refresh("solid"));
    state.watch(["surface"], () => this.refresh());
    state.watch(
      axes.map((a) => `cut${a}`),
      () => this.refresh(),
    );
    state.watch([...axes, "lines"], () => this.drawOverlay());
    state.watch(turned, () => {
      if (turned.every((key) => this.look[key] === state.get(key))) return;
      this.look = Object.fromEntries(turned.map((key) => [key, state.get(key)]));
      this.#zoomTo(this.look.zoom);
      this.refresh();
    });
  }

  #sayWhy() {
    this.canvas.hidden = true;
    this.stage.append(h("p", { class: "nothing" }, noPicture));
  }

  #listen() {
    if (!this.scene) return;
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
      click: (place) => this.#leadSlices(place),
      reset: () => {
        this.camera.fit(this.extent, this.margin);
        this.#turnTo(firstLook);
      },
      scrolled: () => this.sayHow(),
    });
  }

  /** Half of the longest diagonal, so that the sample stays in sight however it is turned. */
  get extent() {
    const r = (Math.hypot(...this.result.size) * this.result.spacing) / 2;
    return { left: -r, right: r, bottom: -r, top: r };
  }
  get frame() {
    return frameOf(this.look.azimuth, this.look.elevation);
  }
  get kept() {
    return axes.map((axis) => this.state.get(`cut${axis}`));
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

  /** The code of the field below which voxels are not seen. */
  get level() {
    return this.state.get("show") === "field" ? this.result.codeOfLevel(this.state.get("level")) : 1;
  }
  /** Whether a voxel is, by its number. */
  get isSeen() {
    const { result, state, level } = this,
      isOn = [false, state.get("matrix"), state.get("particle")],
      codes = level > 1 ? result.codes(state.get("component")) : null;
    return (voxel) => isOn[result.phase[voxel]] && (!codes || codes[voxel] >= level);
  }

  update(stale) {
    const { scene, result, state, theme } = this;
    if (stale.size > 0) this.keptLegend = null;
    if (!scene) return;
    if (stale.has("index")) scene.setVoxels("index", indexOf(result, state));
    if (stale.has("table")) scene.setTable(tableOf(result, state, theme));
    if (stale.has("solid")) {
      const { isSeen } = this,
        seen = result.phase.map((_, voxel) => (isSeen(voxel) ? 255 : 0));
      scene.setVoxels("seen", seen);
      scene.setVoxels("solid", filling(seen, result.size));
    }
  }

  paint(pixelRatio = this.pixelRatio) {
    const { camera, result, state, theme } = this;
    this.scene?.draw({
      frame: this.frame,
      kept: this.kept,
      isSurface: state.get("surface"),
      perPixel: 1 / (camera.scale * pixelRatio * result.spacing),
      middle: [camera.x / result.spacing, camera.y / result.spacing],
      card: theme.card,
      finer: this.rests && pixelRatio < 2 ? 2 : 1,
      glow: theme.name === "dark" ? 0.3 : 0,
    });
  }

  /** A point of space, in voxels from the middle, in the picture. */
  #toScreen = (point) => this.camera.toScreen(...along(this.frame, point).map((value) => value * this.result.spacing));

  #outline() {
    const slices = this.state.get("lines") ? axes.map((axis) => this.state.get(axis)) : null;
    return outline(this.frame, this.result.size, this.kept, slices, this.#toScreen, this.theme);
  }

  drawOverlay() {
    this.over.replaceChildren(...(this.scene ? [this.#outline()] : []));
  }

  legend() {
    const { width, scale } = this.camera,
      key = `${width} ${scale}`;
    if (!this.keptLegend || this.legendKey !== key) {
      this.legendKey = key;
      this.keptLegend = this.#newLegend();
    }
    return this.keptLegend;
  }
  #newLegend(less = 0) {
    return legend(this.result, this.state, this.theme, this.camera.width - less, this.scene && this.camera);
  }

  /** The voxel that is seen at a place of the picture, or null. */
  cellAt(place) {
    const { result, camera, isSeen } = this,
      point = camera.toWorld(...place).map((value) => value / result.spacing);
    return seenCell(this.frame, point, result.size, this.kept, (cell) => isSeen(result.voxelAt(cell)));
  }

  pick(place) {
    const cell = this.cellAt(place);
    if (cell === null) return this.unpick();
    this.picked = cell;
    this.tooltip.write(voxelNumbers(this.result, cell, this.theme, this.state.get("component")), place);
  }

  #leadSlices(place) {
    const cell = this.cellAt(place);
    if (cell) this.state.set({ x: cell[0], y: cell[1], z: cell[2] });
  }

  get name() {
    const { result, state } = this;
    return fileName(result.title, result.name, state.get("show") === "field" ? state.get("component") : "phases");
  }

  savePng() {
    const { height } = this.camera;
    const below = s("g", { transform: `translate(${saveMargin} ${height + 4})` }, this.#newLegend(2 * saveMargin));
    return this.savePainted(this.name, height + legendHeight + 4, this.#outline(), below);
  }

  saveSvg() {
    const { width, height } = this.camera,
      whole = height + legendHeight + 4;
    this.paint();
    const svg = s(
      "svg",
      { width, height: whole, viewBox: `0 0 ${width} ${whole}` },
      s("image", { href: this.canvas.toDataURL("image/png"), x: 0, y: 0, width, height }),
      this.#outline(),
      s("g", { transform: `translate(${saveMargin} ${height + 4})` }, this.#newLegend(2 * saveMargin)),
    );
    saveSvg(this.name, svg, this.theme);
  }
}
