import { drawn } from "../drawn.js";
import { programOf } from "../space/program.js";
import { bytes } from "../theme.js";
import { fragment, vertex } from "./shaders.js";

const units = { seen: 0, index: 1, solid: 2, table: 3 };

/** The voxels on the graphics card as three textures in space: which are seen, rows of the colour table, and how
    much of the neighbourhood of a place is seen. */
export class VolumeScene {
  #gl;
  #at;

  /** Null where the browser has no WebGL2, or the sample is too long for it. */
  static on(canvas, size) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
    if (!gl || Math.max(...size) > gl.getParameter(gl.MAX_3D_TEXTURE_SIZE)) return null;
    return new VolumeScene(gl, size);
  }

  constructor(gl, size) {
    Object.assign(this, { size, canvas: gl.canvas });
    this.#gl = gl;
    const program = programOf(gl, vertex, fragment, "volume");
    gl.useProgram(program);
    this.#at = (name) => gl.getUniformLocation(program, name);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    for (const [name, unit] of Object.entries(units)) {
      const target = name === "table" ? gl.TEXTURE_2D : gl.TEXTURE_3D,
        filter = name === "solid" ? gl.LINEAR : gl.NEAREST;
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(target, gl.createTexture());
      for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, ...(name === "table" ? [] : [gl.TEXTURE_WRAP_R])])
        gl.texParameteri(target, side, gl.CLAMP_TO_EDGE);
      gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, filter);
      gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, filter);
      gl.uniform1i(this.#at(name), unit);
    }
    gl.uniform3f(this.#at("size"), ...size);
  }

  /** Bytes of all voxels: "seen" (not 0), "index" or "solid". */
  setVoxels(name, data) {
    const gl = this.#gl;
    gl.activeTexture(gl.TEXTURE0 + units[name]);
    gl.texImage3D(gl.TEXTURE_3D, 0, gl.R8, ...this.size, 0, gl.RED, gl.UNSIGNED_BYTE, data);
  }

  setTable(rgba) {
    const gl = this.#gl;
    gl.activeTexture(gl.TEXTURE0 + units.table);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  }

  /** `perPixel` voxels a pixel, `middle` the point of the picture's plane in its middle, in voxels; `finer` times
      `finer` lines of sight a pixel; `glow` lights the shapes of dark colours. */
  draw({ frame, kept, isSurface, perPixel, middle, card, finer, glow }) {
    const gl = this.#gl,
      { width, height } = this.canvas;
    gl.viewport(0, 0, width, height);
    for (const [name, direction] of Object.entries(frame)) gl.uniform3f(this.#at(name), ...direction);
    gl.uniform3f(this.#at("light"), ...drawn().light);
    gl.uniform3f(this.#at("kept"), ...kept);
    gl.uniform3f(this.#at("card"), ...bytes(card).map((v) => v / 255));
    gl.uniform2f(this.#at("middle"), ...middle);
    gl.uniform2f(this.#at("canvas"), width, height);
    gl.uniform1f(this.#at("perPixel"), perPixel);
    gl.uniform1f(this.#at("glow"), glow);
    gl.uniform1i(this.#at("finer"), finer);
    gl.uniform1i(this.#at("isSurface"), Number(isSurface));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

/** How much of the neighbourhood of every voxel is seen, 0 to 255: means with weights 1, 2, 1 along each axis of those
    that are seen (255, others 0). */
export function filling(seen, size) {
  let from = seen.slice(),
    to = new Uint8Array(from.length);
  const [width, height] = size,
    steps = [1, width, width * height];
  size.forEach((n, axis) => {
    const step = steps[axis];
    for (let k = 0; k < from.length; ++k) {
      const at = Math.floor(k / step) % n;
      to[k] = (from[at > 0 ? k - step : k] + 2 * from[k] + from[at < n - 1 ? k + step : k] + 2) >> 2;
    }
    [from, to] = [to, from];
  });
  return from;
}
