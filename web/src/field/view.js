import { CanvasView } from "../canvas_view.js";
import { s } from "../dom.js";
import { closeUp } from "./close_up.js";
import { brokenAt, crackBuffers } from "./cracks.js";
import { barBuffers, crossesInGrain, crossesOf } from "./crosses.js";
import { displacedBox, magnification } from "./deformation.js";
import { legend, legendHeight } from "./legend.js";
import { paint } from "./paint.js";
import { FieldScene } from "./scene.js";
import { nodeNumbers } from "./tooltip.js";

const label = "The sample; a click shows a close-up of a grain";
const painted = ["show", "component", "around", "law", "clip", "by", "chains", "threshold", "cavities", "theme"];

/** The picture of a sample on a grid: canvas, overlay, legend and what the pointer does on them. */
export class FieldView extends CanvasView {
  constructor(result, state) {
    super(state, {
      name: "nodes",
      label,
      margin: 8,
      key: "key field-key",
      legendHeight,
      parts: ["paint", "crosses", "cracks"],
      beside: closeUp(result, state),
    });
    this.result = result;
    this.scene = new FieldScene(this.canvas, result.map);
    this.listen({
      click: (place) => this.#choose(place),
      reset: () => (state.get("grain") ? state.set({ grain: 0 }) : this.reset()),
    });
    state.watch(painted, () => this.refresh("paint"));
    state.watch(["crosses", "theme"], () => this.refresh("crosses"));
    state.watch(["step", "cracks", "theme"], () => this.refresh("cracks"));
    state.watch(["outlines"], () => this.refresh());
    state.watch(["deform"], () => {
      if (this.camera.fitted) this.fit();
      this.refresh("crosses", "cracks");
    });
    state.watch(["grain"], () => {
      this.#look();
      this.refresh("crosses");
    });
  }

  /** How many times displacements are drawn larger; 0: as it was before it was loaded. */
  get times() {
    return this.state.get("deform") > 0 ? magnification(this.result, this.state.get("deform")) : 0;
  }
  get extent() {
    return this.times ? displacedBox(this.result, this.times) : this.result.map.box;
  }
  get broken() {
    return this.state.get("cracks") ? brokenAt(this.result, this.state.get("step")) : 0;
  }
  get look() {
    const { state } = this;
    const veiled = this.result.cracks && state.get("cracks") && state.get("show") !== "field";
    return {
      outline: state.get("outlines"),
      chosen: state.get("grain"),
      fade: veiled ? 0.45 : 0,
      deformed: this.times ? { result: this.result, times: this.times } : null,
    };
  }

  bars() {
    const { result, state } = this,
      grain = state.get("grain");
    if (!state.get("crosses") || !result.loaded || this.times) return [];
    return grain ? crossesInGrain(result, this.theme, grain - 1) : crossesOf(result, this.theme);
  }

  /** A chosen grain fills the picture; without one the whole sample is shown. */
  #look() {
    const grain = this.state.get("grain");
    this.fit();
    if (!grain) return;
    this.camera.show(this.result.boxOfGrain(grain - 1), 0.16 * Math.min(this.camera.width, this.camera.height));
    this.followCamera();
  }

  update(stale) {
    const { result, scene, state, theme, broken } = this;
    if (stale.has("paint")) scene.setPaint(paint(result, state, theme));
    if (stale.has("crosses")) scene.setLayer("crosses", barBuffers(this.bars(), scene.origin));
    if (stale.has("cracks"))
      scene.setLayer("cracks", broken ? crackBuffers(result, broken, theme, scene.origin, this.times) : { count: 0 });
  }

  paint(pixelRatio = this.pixelRatio) {
    this.scene.draw(this.camera, pixelRatio, this.theme, this.look);
  }

  legend() {
    return legend(this.result, this.camera, this.theme, this.state, this.camera.width, this.broken);
  }

  /** A square around the node under the pointer once nodes can be told apart. */
  drawOverlay() {
    const size = this.result.map.spacing * this.camera.scale;
    if (this.picked === null || size < 4) return this.over.replaceChildren();
    const [x, y] = this.camera.toScreen(...this.result.map.placeOf(this.picked));
    this.over.replaceChildren(
      s("rect", {
        x: x - size / 2,
        y: y - size / 2,
        width: size,
        height: size,
        fill: "none",
        stroke: this.theme.ink,
        "stroke-width": 1.5,
      }),
    );
  }

  /** None in a deformed picture, where another one may lie. */
  #node([px, py]) {
    return this.times ? null : this.result.map.nodeAt(...this.camera.toWorld(px, py));
  }

  #choose(place) {
    const node = this.#node(place);
    const label = node === null ? 0 : this.result.map.label[node];
    if (label && label !== this.state.get("grain")) this.state.set({ grain: label });
  }

  pick(place) {
    const node = this.#node(place);
    if (node === null) return this.unpick();
    this.picked = node;
    this.drawOverlay();
    this.tooltip.write(nodeNumbers(this.result, node, this.theme, this.state.get("show")), place);
  }
}
