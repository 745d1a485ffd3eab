import createRegl from "regl";
import { segmentDrawing } from "../packing/segments.js";
import { bytes } from "../theme.js";
import { deformedDrawing, nodeBuffers } from "./deformation.js";
import { gridDrawing } from "./grid.js";

const unit = (colour) => bytes(colour).map((v) => v / 255);
const crackRadius = 1.5; // pixels of the screen at least

/** The grid of nodes on the graphics card, with crosses and cracks over it. */
export class FieldScene {
  constructor(canvas, map) {
    this.map = map;
    const regl = (this.regl = createRegl({
      canvas,
      attributes: { antialias: false, alpha: false, preserveDrawingBuffer: true },
      extensions: ["ANGLE_instanced_arrays"],
    }));
    this.grid = gridDrawing(regl);
    this.segments = segmentDrawing(
      regl,
      regl.buffer([
        [-1, -1],
        [1, -1],
        [-1, 1],
        [1, 1],
      ]),
    );
    const { box, width, height } = map;
    this.size = [box.right, box.top];
    // Positions go to the card relative to the middle, where float32 is finest.
    this.origin = { x: box.right / 2, y: box.top / 2 };
    this.paint = regl.texture({ width, height, min: "linear", mag: "linear" });
    this.label = regl.texture({ width, height, data: labelBytes(map) });
    this.layers = Object.fromEntries(
      ["crosses", "cracks"].map((name) => [
        name,
        {
          count: 0,
          ...Object.fromEntries(
            ["ends", "width", "colour"].map((part) => [part, regl.buffer({ usage: "dynamic", length: 4 })]),
          ),
        },
      ]),
    );
  }

  /** Nodes where they went, made when they are first asked for. */
  #displaced(result, rgba) {
    if (!this.deformed) {
      const { nodes, place, move } = nodeBuffers(result, this.origin),
        { regl } = this;
      this.deformed = {
        nodes,
        draw: deformedDrawing(regl),
        place: regl.buffer(place),
        move: regl.buffer(move),
        colour: regl.buffer({ usage: "dynamic", length: 4 }),
        count: nodes.length,
      };
    }
    if (this.deformed.of === rgba) return;
    const all = new Uint32Array(rgba.buffer);
    this.deformed.of = rgba;
    this.deformed.colour({
      data: new Uint8Array(Uint32Array.from(this.deformed.nodes, (k) => all[k]).buffer),
      usage: "dynamic",
    });
  }

  setPaint(rgba) {
    this.rgba = rgba;
    this.paint({ width: this.map.width, height: this.map.height, data: rgba, min: "linear", mag: "linear" });
  }

  setLayer(name, { ends, width, colour, count }) {
    const layer = this.layers[name];
    layer.count = count;
    if (count === 0) return;
    layer.ends({ data: ends, usage: "dynamic" });
    layer.width({ data: width, usage: "dynamic" });
    layer.colour({ data: colour, usage: "dynamic" });
  }

  draw(camera, pixelRatio, theme, { outline, chosen, fade, deformed = null }) {
    const pixelsPerMetre = camera.scale * pixelRatio;
    const perMetre = [(2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height];
    const pixelsPerNode = pixelsPerMetre * this.map.spacing;
    this.regl.poll();
    this.regl.clear({ color: [...unit(theme.card), 1] });
    if (deformed) {
      this.#displaced(deformed.result, this.rgba);
      this.deformed.draw({
        ...this.deformed,
        middle: [camera.x - this.origin.x, camera.y - this.origin.y],
        perMetre,
        times: deformed.times,
        size: Math.max(1, 1.12 * pixelsPerNode + 0.5),
        background: unit(theme.card),
        fade,
      });
    } else
      this.grid({
        middle: [camera.x, camera.y],
        perMetre,
        size: this.size,
        nodes: [this.map.width, this.map.height],
        paint: this.paint,
        label: this.label,
        background: unit(theme.card),
        ink: unit(theme.field.outline),
        pixelsPerNode,
        chosen: chosen ?? 0,
        fade,
        outline: outline ? Math.min(0.75, 0.2 + 0.25 * pixelsPerNode) : 0,
      });
    const view = { middle: [camera.x - this.origin.x, camera.y - this.origin.y], perMetre, pixelsPerMetre };
    for (const [name, layer] of Object.entries(this.layers))
      if (layer.count)
        this.segments({ ...view, ...layer, ...(name === "cracks" ? { hairline: crackRadius * pixelRatio } : {}) });
  }
}

/** Grain labels in three bytes, so that the card can tell grains apart; void and matrix stand apart from each other
    too. */
function labelBytes({ label, kind }) {
  const out = new Uint32Array(label.length);
  for (let k = 0; k < label.length; ++k) out[k] = label[k] > 0 ? label[k] : kind[k] === 0 ? 0xfffffe : 0xffffff;
  return new Uint8Array(out.buffer);
}
