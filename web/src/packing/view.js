import { CanvasView } from "../canvas_view.js";
import { s } from "../dom.js";
import { fileName, saveSvg } from "../save.js";
import { legend, legendHeight } from "./legend.js";
import { overlay } from "./overlay.js";
import { Picker } from "./picking.js";
import { mostVectors, packingSvg } from "./picture.js";
import { Scene } from "./scene.js";

const label = "The packing";

/** The grain whose row of the table, or point of a chart, the pointer is on. */
const pointed = (state) => (state.get("pointed") === null ? null : { grain: state.get("pointed") });

/** The picture of the packing: canvas, overlay, legend and what the pointer does on them. */
export class PackingView extends CanvasView {
  constructor(sample, state) {
    super(state, { name: "grains", label, margin: 26, legendHeight, parts: ["positions", "colours", "chains"] });
    this.sample = sample;
    this.scene = new Scene(this.canvas, sample);
    this.listen({ click: () => this.select() });
    state.watch(["snapshot"], () => this.refresh("positions", "colours", "chains"));
    state.watch(["colour", "scales"], () => this.refresh("colours"));
    state.watch(["theme"], () => this.refresh("colours", "chains"));
    state.watch(["selected", "pointed"], () => this.sized && this.drawOverlay());
    state.watch(["chains", "types", "strength", "marks"], () => this.refresh("chains"));
  }

  get snapshot() {
    return this.sample.snapshot(this.state.get("snapshot"));
  }

  refresh(...parts) {
    if (parts.includes("positions")) {
      this.picker = null;
      if (this.camera.fitted) this.fit();
    }
    super.refresh(...parts);
  }

  get extent() {
    return this.sample.extent(this.state.get("snapshot"));
  }

  update(stale) {
    const { snapshot, theme, state } = this;
    if (stale.has("positions")) this.scene.updatePositions(snapshot);
    if (stale.has("colours")) this.scene.updateColours(snapshot, state, theme);
    if (stale.has("chains")) this.scene.updateChains(state, snapshot, theme);
  }

  paint(pixelRatio = this.pixelRatio) {
    this.scene.draw(this.camera, pixelRatio, this.theme, this.state);
  }

  legend() {
    return legend(this.sample, this.snapshot, this.camera, this.theme, this.state, this.camera.width);
  }

  drawOverlay() {
    this.over.replaceChildren(
      overlay(this.sample, this.snapshot, this.camera, this.theme, {
        walls: true,
        picked: this.picked ?? pointed(this.state),
        selected: this.state.get("selected"),
      }),
    );
  }

  pick([px, py]) {
    this.picker ??= new Picker(this.sample, this.snapshot);
    const [x, y] = this.camera.toWorld(px, py);
    const contact = this.state.get("chains") ? this.picker.contact(x, y, 2.5 / this.camera.scale, this.state) : null;
    const grain = contact === null ? this.picker.grain(x, y) : null;
    if (contact === null && grain === null) return this.unpick();
    this.picked = contact !== null ? { contact } : { grain };
    this.drawOverlay();
    this.tooltip.show(this.picked, this.sample, this.snapshot, this.theme, [px, py]);
  }

  /** The grain under the pointer, which table and charts mark too; none where it is there already, or where no grain
      is. */
  select() {
    const grain = this.picked?.grain ?? null;
    this.state.set({ selected: grain === this.state.get("selected") ? null : grain });
  }

  get name() {
    return fileName(this.sample.title, "packing", this.state.get("colour"));
  }

  get vectors() {
    return this.sample.count + (this.state.get("chains") ? this.snapshot.contacts.fn.length : 0);
  }
  get fewEnoughForSvg() {
    return this.vectors < mostVectors;
  }

  saveSvg() {
    const svg = packingSvg(this.sample, this.snapshot, this.camera, this.theme, this.state);
    saveSvg(this.name, svg, this.theme);
  }

  savePng() {
    const { camera, theme } = this;
    return this.savePainted(
      this.name,
      camera.height + legendHeight + 8,
      overlay(this.sample, this.snapshot, camera, theme, { walls: true }),
      s("g", { transform: `translate(0 ${camera.height + 4})` }, this.legend()),
    );
  }
}
