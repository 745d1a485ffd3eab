import createRegl from "regl";
import { isPresent } from "../sample.js";
import { bytes } from "../theme.js";
import { chainBuffers } from "./chains.js";
import { fadeUnderChains, grainColours, scaleOf } from "./colouring.js";
import { diskDrawing } from "./disks.js";
import { segmentDrawing } from "./segments.js";
import { ShapeScene } from "./shapes.js";

const farAway = 1e9; // m
const unit = (colour) => bytes(colour).map((v) => v / 255);

/** The packing on the graphics card. `update` uploads what a change of state touches, `draw` paints one picture. */
export class Scene {
  constructor(canvas, sample) {
    this.sample = sample;
    this.regl = createRegl({
      canvas,
      extensions: ["ANGLE_instanced_arrays", ...(sample.shapes ? ["OES_element_index_uint"] : [])],
      attributes: { antialias: false, alpha: false, preserveDrawingBuffer: true },
    });
    const corner = this.regl.buffer([
      [-1, -1],
      [1, -1],
      [-1, 1],
      [1, 1],
    ]);
    this.disks = diskDrawing(this.regl, corner);
    this.segments = segmentDrawing(this.regl, corner);
    if (sample.shapes) this.shapes = new ShapeScene(this.regl, sample, this.segments);
    const box = sample.box(sample.snapshot(sample.snapshotCount - 1));
    // Positions go to the card relative to the middle of the box, where float32 is finest.
    this.origin = { x: (box.left + box.right) / 2, y: (box.bottom + box.top) / 2 };
    const dynamic = () => this.regl.buffer({ usage: "dynamic", length: 4 });
    this.grains = {
      centre: dynamic(),
      angle: dynamic(),
      colour: dynamic(),
      radius: this.regl.buffer(sample.radius),
      ring: this.regl.buffer(Uint8Array.from(sample.zone, (z) => (z > 0 ? 255 : 0))),
    };
    this.chains = { ends: dynamic(), width: dynamic(), colour: dynamic(), count: 0 };
  }

  updatePositions(snapshot) {
    const centre = new Float32Array(2 * this.sample.count);
    for (let g = 0; g < this.sample.count; ++g) {
      const there = isPresent(snapshot, g);
      centre[2 * g] = there ? snapshot.x[g] - this.origin.x : farAway;
      centre[2 * g + 1] = there ? snapshot.y[g] - this.origin.y : farAway;
    }
    this.grains.centre({ data: centre, usage: "dynamic" });
    this.grains.angle({ data: snapshot.angle, usage: "dynamic" });
    this.shapes?.updatePositions(snapshot, this.origin);
  }

  updateColours(snapshot, state, theme) {
    const colours = grainColours(this.sample, snapshot, state.get("colour"), scaleOf(this.sample, state), theme);
    this.grains.colour({ data: colours, usage: "dynamic" });
    this.shapes?.updateColours(colours, bytes(theme.ink));
  }

  updateChains(state, snapshot, theme) {
    const { ends, width, colour, count } = chainBuffers(state, this.sample, snapshot, theme, this.origin);
    this.chains.count = count;
    if (count === 0) return;
    this.chains.ends({ data: ends, usage: "dynamic" });
    this.chains.width({ data: width, usage: "dynamic" });
    this.chains.colour({ data: colour, usage: "dynamic" });
  }

  draw(camera, pixelRatio, theme, state) {
    const chains = state.get("chains");
    const pixelsPerMetre = camera.scale * pixelRatio;
    const view = {
      middle: [camera.x - this.origin.x, camera.y - this.origin.y],
      perMetre: [(2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height],
      pixelsPerMetre,
      background: unit(theme.card),
      ink: unit(theme.ink),
      fade: chains ? fadeUnderChains(state.get("colour")) : 0,
      marks: state.get("marks") ? 1 : 0,
    };
    this.regl.poll();
    this.regl.clear({ color: [...unit(theme.card), 1] });
    if (this.shapes) this.shapes.draw(view);
    else this.disks({ ...view, ...this.grains, count: this.sample.count });
    if (chains && this.chains.count) this.segments({ ...view, ...this.chains });
  }
}
