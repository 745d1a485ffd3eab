import { instances } from "./instances.js";

/** Draws disks as squares with a round, smooth edge computed in the fragment shader; `corner` is shared by all. */
export function diskDrawing(regl, corner) {
  return regl({
    vert: `
      precision highp float;
      attribute vec2 corner, centre;
      attribute float radius, angle, ring;
      attribute vec4 colour;
      uniform vec2 middle, perMetre;
      uniform float pixelsPerMetre;
      varying vec2 place;
      varying vec4 fill;
      varying float size, turn, edge;
      void main() {
        size = radius * pixelsPerMetre;
        place = corner * (size + 1.0);
        fill = colour;
        turn = angle;
        edge = ring;
        gl_Position = vec4((centre - middle + corner * (radius + 1.0 / pixelsPerMetre)) * perMetre, 0.0, 1.0);
      }`,
    frag: `
      precision highp float;
      uniform vec3 background, ink;
      uniform float fade, marks;
      varying vec2 place;
      varying vec4 fill;
      varying float size, turn, edge;
      void main() {
        float inside = size - length(place);
        float cover = clamp(inside + 0.5, 0.0, 1.0);
        if (cover <= 0.0) discard;
        vec3 body = mix(fill.rgb, background, fade);
        float width = clamp(0.05 * size, 0.5, 2.0) * (1.0 + 1.5 * edge);
        float rim = smoothstep(width + 0.6, width - 0.4, inside) * clamp((size - 1.5) / 3.0, 0.0, 1.0);
        vec3 colour = mix(body, ink, rim * (0.28 + 0.5 * edge));
        vec2 axis = vec2(cos(turn), sin(turn));
        float along = dot(place, axis), across = abs(dot(place, vec2(-axis.y, axis.x)));
        float spoke = clamp(0.04 * size + 0.5 - across, 0.0, 1.0) * clamp(along - 0.1 * size, 0.0, 1.0)
                    * clamp(0.8 * size - along, 0.0, 1.0);
        vec3 mark = vec3(dot(body, vec3(0.3, 0.59, 0.11)) > 0.4 ? 0.1 : 0.95);
        colour = mix(colour, mark, marks * 0.8 * spoke);
        gl_FragColor = vec4(colour, cover * fill.a);
      }`,
    ...instances(regl, corner, { centre: "floats", radius: "floats", angle: "floats", ring: "bytes", colour: "bytes" }),
    uniforms: {
      middle: regl.prop("middle"),
      perMetre: regl.prop("perMetre"),
      pixelsPerMetre: regl.prop("pixelsPerMetre"),
      background: regl.prop("background"),
      ink: regl.prop("ink"),
      fade: regl.prop("fade"),
      marks: regl.prop("marks"),
    },
  });
}
