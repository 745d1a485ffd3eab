import { programOf } from "../space/program.js";
import { bytes } from "../theme.js";
import { lineShaders, sphereShaders } from "./shaders.js";

const beyond = 1e9; // m: where nothing is cut

/** Shapes of one kind on the graphics card, of which each is four corners: `attributes` = [[name, numbers of a shape,
    bytes of colours or floats]]. */
class Shapes {
  #gl;
  #buffers = {};
  count = 0;

  constructor(gl, { vertex, fragment }, attributes) {
    this.#gl = gl;
    this.program = programOf(gl, vertex, fragment, "spheres");
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    attributes.forEach(([name, numbers, type, stride = 0, offset = 0], location) => {
      this.#buffers[name] ??= gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers[name]);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, numbers, gl[type], type === "UNSIGNED_BYTE", stride, offset);
      gl.vertexAttribDivisor(location, 1);
    });
  }

  set(name, data) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  }

  draw(uniforms) {
    const gl = this.#gl;
    gl.useProgram(this.program);
    for (const [name, values] of Object.entries(uniforms)) gl[`uniform${values.length}f`](this.at(name), ...values);
    gl.bindVertexArray(this.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.count);
  }
}

/** Spheres, and the lines of the forces between them, on the graphics card. */
export class SphereScene {
  #gl;

  /** Null where the browser has no WebGL2. */
  static on(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, preserveDrawingBuffer: true });
    return gl && new SphereScene(gl);
  }

  constructor(gl) {
    this.#gl = gl;
    this.canvas = gl.canvas;
    this.spheres = new Shapes(gl, sphereShaders, [
      ["ball", 4, "FLOAT"],
      ["colour", 4, "UNSIGNED_BYTE"],
    ]);
    this.lines = new Shapes(gl, lineShaders, [
      ["ends", 3, "FLOAT", 24, 0],
      ["ends", 3, "FLOAT", 24, 12],
      ["radius", 1, "FLOAT"],
      ["colour", 4, "UNSIGNED_BYTE"],
    ]);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE);
  }

  /** `scale` pixels a metre, `middle` the point of the picture's plane in its middle, `kept` where is cut, `reach` how
      far anything lies from the middle, m; `glow` and `lineGlow` light the shapes of dark colours. Spheres are seen
      through where `pale` (their opacity) is below 1, and are not there where it is 0. */
  draw({ frame, kept, scale, middle, reach, card, glow, lineGlow, pale, withLines }) {
    const gl = this.#gl,
      { width, height } = this.canvas;
    gl.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clearColor(...bytes(card).map((v) => v / 255), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const shared = {
      ...frame,
      kept: kept.map((place) => Math.min(place, beyond)),
      middle,
      perSide: [(2 * scale) / width, (2 * scale) / height],
      reach: [reach],
      glow: [glow],
    };
    gl.disable(gl.BLEND);
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    if (withLines) this.lines.draw({ ...shared, glow: [lineGlow], pale: [1] });
    if (pale < 1) {
      gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
      gl.enable(gl.BLEND);
      gl.depthMask(false);
    }
    if (pale > 0) this.spheres.draw({ ...shared, pale: [pale] });
  }
}
