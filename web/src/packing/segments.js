import { instances } from "./instances.js";

/** Draws segments with round ends and a width in metres; what would be thinner than a hairline is drawn fainter.
    A hairline of 1 pixel or more (half its width) keeps dots in sight from afar. */
export function segmentDrawing(regl, corner) {
  return regl({
    vert: `
      precision highp float;
      attribute vec2 corner;
      attribute vec4 ends;
      attribute float width;
      attribute vec4 colour;
      uniform vec2 middle, perMetre;
      uniform float pixelsPerMetre, hairline;
      varying vec2 place;
      varying vec4 paint;
      varying float halfLength, halfWidth;
      void main() {
        vec2 span = ends.zw - ends.xy;
        float length_ = max(length(span), 1e-12);
        vec2 along = span / length_;
        halfLength = 0.5 * length_ * pixelsPerMetre;
        float wanted = 0.5 * width * pixelsPerMetre;
        halfWidth = max(wanted, hairline);
        place = corner * vec2(halfLength + halfWidth + 1.0, halfWidth + 1.0);
        vec2 offset = (along * place.x + vec2(-along.y, along.x) * place.y) / pixelsPerMetre;
        paint = vec4(colour.rgb, colour.a * max(step(1.0, hairline), clamp(wanted / hairline, 0.35, 1.0)));
        gl_Position = vec4((0.5 * (ends.xy + ends.zw) - middle + offset) * perMetre, 0.0, 1.0);
      }`,
    frag: `
      precision highp float;
      varying vec2 place;
      varying vec4 paint;
      varying float halfLength, halfWidth;
      void main() {
        float outside = length(vec2(max(abs(place.x) - halfLength, 0.0), place.y)) - halfWidth;
        float cover = clamp(0.5 - outside, 0.0, 1.0);
        if (cover <= 0.0) discard;
        gl_FragColor = vec4(paint.rgb, paint.a * cover);
      }`,
    ...instances(regl, corner, { ends: "floats", width: "floats", colour: "bytes" }),
    uniforms: {
      middle: regl.prop("middle"),
      perMetre: regl.prop("perMetre"),
      pixelsPerMetre: regl.prop("pixelsPerMetre"),
      hairline: (_, { hairline = 0.55 }) => hairline,
    },
  });
}
