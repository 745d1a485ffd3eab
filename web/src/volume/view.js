import { fileName } from "../save.js";
import { axes } from "../space/frame.js";
import { outline } from "../space/outline.js";
import { SpaceView } from "../space/view.js";
import { legend, legendHeight } from "./legend.js";
import { indexOf, painted, tableOf } from "./paint.js";
import { seenCell } from "./ray.js";
import { filling, VolumeScene } from "./scene.js";
import { voxelNumbers } from "./tooltip.js";

const label = "The sample in space, in which a click leads the slices to what is seen there";
const without = "This browser has no WebGL2, which the picture in space needs; the slices show the same values.";

/** The sample as it is seen from a side: what is cut away and phases that are switched off are transparent. */
export class VolumeView extends SpaceView {
  constructor(result, state) {
    super(state, {
      name: "volume",
      label,
      without,
      margin: 6,
      key: "key volume-key",
      legendHeight,
      parts: ["index", "table", "solid"],
      makeScene: (canvas) => VolumeScene.on(canvas, result.size),
    });
    this.result = result;
    state.watch(painted, () => this.refresh("index", "table"));
    state.watch(["matrix", "particle", "level"], () => this.refresh("solid"));
    state.watch(["show", "component"], () => state.get("level") > 0 && this.refresh("solid"));
    state.watch(["surface"], () => this.refresh());
    state.watch([...axes, "lines"], () => this.drawOverlay());
  }

  get size() {
    return this.result.size;
  }
  get spacing() {
    return this.result.spacing;
  }
  get kept() {
    return axes.map((axis) => this.state.get(`cut${axis}`));
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

  outline() {
    const slices = this.state.get("lines") ? axes.map((axis) => this.state.get(axis)) : null;
    return outline(this.frame, this.result.size, this.kept, slices, this.toScreen, this.theme);
  }

  newLegend(less = 0) {
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

  click(place) {
    const cell = this.cellAt(place);
    if (cell) this.state.set({ x: cell[0], y: cell[1], z: cell[2] });
  }

  get name() {
    const { result, state } = this;
    return fileName(result.title, result.name, state.get("show") === "field" ? state.get("component") : "phases");
  }
}
