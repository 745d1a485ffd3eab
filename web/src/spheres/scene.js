import { drawn } from "../drawn.js";
import { programOf } from "../space/program.js";
import { bytes } from "../theme.js";
import { lineShaders, sphereShaders } from "./shaders.js";

const beyond = 1e9; // m: where nothing is cut

const corners = 4;

/** What shapes have as what each of their corners has. */
function byCorner(data, numbers) {
  const all = new data.constructor(corners * data.length);
  for (let shape = 0, to = 0; shape < data.length; shape += numbers)
    for (let corner = 0; corner < corners; ++corner)
      for (let k = 0; k < numbers; ++k) all[to++] = data[shape + k];
  return all;
}

/** Shapes of one kind on the graphics card, of which each is four corners: `attributes` = [[name, numbers of a shape,
    bytes of colours or floats]]. Each corner has all of its shape's numbers: instances of four corners take four times
    as long where there is no graphics card. */
class Shapes {
  #gl;
  #buffers = {};
  #numbers = {}; // of a shape in each buffer
  #indices;
  #room = 0; // shapes that there are indices for
  count = 0;

  constructor(gl, { vertex, fragment }, attributes) {
    this.#gl = gl;
    this.program = programOf(gl, vertex, fragment, "spheres");
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    attributes.forEach(([name, numbers, type, stride = 0, offset = 0], location) => {
      this.#buffers[name] ??= gl.createBuffer();
      this.#numbers[name] = (this.#numbers[name] ?? 0) + numbers;
      gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers[name]);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, numbers, gl[type], type === "UNSIGNED_BYTE", stride, offset);
    });
    this.#indices = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#indices);
    gl.bindVertexArray(null);
  }

  set(name, data) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, byCorner(data, this.#numbers[name]), gl.STATIC_DRAW);
  }

  /** Two triangles for each shape; its array is bound. */
  #makeRoom() {
    if (this.count <= this.#room) return;
    const indices = new Uint32Array(6 * this.count);
    for (let shape = 0; shape < this.count; ++shape)
      [0, 1, 2, 2, 1, 3].forEach((corner, k) => (indices[6 * shape + k] = corners * shape + corner));
    this.#gl.bufferData(this.#gl.ELEMENT_ARRAY_BUFFER, indices, this.#gl.STATIC_DRAW);
    this.#room = this.count;
  }

  draw(uniforms) {
    const gl = this.#gl;
    gl.useProgram(this.program);
    for (const [name, values] of Object.entries(uniforms)) gl[`uniform${values.length}f`](this.at(name), ...values);
    gl.bindVertexArray(this.array);
    this.#makeRoom();
    gl.drawElements(gl.TRIANGLES, 6 * this.count, gl.UNSIGNED_INT, 0);
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
      light: drawn().light,
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
