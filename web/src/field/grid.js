/** Draws the grid of nodes: every node a square when it is larger than a pixel, the mean of several where it is
    smaller. Lines stand where the label of two neighbours differs; with a chosen grain the rest steps back. */
export function gridDrawing(regl) {
  return regl({
    vert: `
      precision highp float;
      attribute vec2 corner;
      uniform vec2 middle, perMetre, size, nodes;
      varying vec2 place;
      void main() {
        place = (0.5 * corner + 0.5) * nodes;
        gl_Position = vec4(((0.5 * corner + 0.5) * size - middle) * perMetre, 0.0, 1.0);
      }`,
    frag: `
      precision highp float;
      uniform sampler2D paint, label;
      uniform vec2 nodes;
      uniform vec3 background, ink;
      uniform float pixelsPerNode, outline, chosen, fade;
      varying vec2 place;
      float labelAt(vec2 p) {
        vec4 t = texture2D(label, (floor(clamp(p, vec2(0.0), nodes - 0.5)) + 0.5) / nodes);
        return floor(t.r * 255.0 + 0.5) + 256.0 * floor(t.g * 255.0 + 0.5) + 65536.0 * floor(t.b * 255.0 + 0.5);
      }
      vec3 paintAt(vec2 p) { return texture2D(paint, p / nodes).rgb; }
      void main() {
        vec3 colour;
        if (pixelsPerNode >= 1.0) colour = paintAt(floor(place) + 0.5);
        else {
          colour = vec3(0.0);
          for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
              colour += paintAt(place + (vec2(float(i), float(j)) - 1.5) * 0.25 / pixelsPerNode);
          colour /= 16.0;
        }
        float here = labelAt(place);
        if (outline > 0.0) {
          float reach = 0.5 / pixelsPerNode;
          float other = max(abs(labelAt(place + vec2(reach, 0.0)) - labelAt(place - vec2(reach, 0.0))),
                            abs(labelAt(place + vec2(0.0, reach)) - labelAt(place - vec2(0.0, reach))));
          colour = mix(colour, ink, outline * min(other, 1.0));
        }
        colour = mix(colour, background, fade);
        if (chosen > 0.0 && here != chosen) colour = mix(colour, background, 0.72);
        gl_FragColor = vec4(colour, 1.0);
      }`,
    attributes: {
      corner: [
        [-1, -1],
        [1, -1],
        [-1, 1],
        [1, 1],
      ],
    },
    uniforms: Object.fromEntries(
      [
        "middle",
        "perMetre",
        "size",
        "nodes",
        "paint",
        "label",
        "background",
        "ink",
        "pixelsPerNode",
        "outline",
        "chosen",
        "fade",
      ].map((name) => [name, regl.prop(name)]),
    ),
    primitive: "triangle strip",
    count: 4,
    depth: { enable: false },
  });
}
