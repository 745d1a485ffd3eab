/** What both kinds of shapes share: a point from the middle of the container as the picture's two axes and the depth
    towards the viewer, and light from above. */
const view = `#version 300 es
precision highp float;
uniform vec3 right, up, towards, kept;
uniform vec2 middle, perSide;
uniform float reach;
vec3 seen(vec3 place) {
  return vec3(dot(right, place), dot(up, place), dot(towards, place));
}
vec4 onPicture(vec2 place) {
  return vec4((place - middle) * perSide, 0.0, 1.0);
}
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);
vec2 corner() {
  return vec2(gl_VertexID % 2, gl_VertexID / 2 % 2) * 2.0 - 1.0;
}
`;

const shading = `#version 300 es
precision highp float;
uniform float reach, glow, pale;
uniform vec3 light;
out vec4 colour;
void shade(vec3 normal, vec3 pure, float depth, float edge) {
  float bright = 0.5 + 0.58 * max(dot(normal, light), 0.0);
  float rim = mix(0.66, 1.0, smoothstep(0.0, 0.45, normal.z));
  colour = vec4(pure * min(1.0, bright) * rim + glow * (bright - 0.5) * rim, pale < 1.0 ? pale : edge);
  gl_FragDepth = 0.5 - 0.5 * depth / reach;
}
/** How much of a pixel at this distance over the radius is inside. */
float inside(float distance_) {
  return clamp((1.0 - distance_) / max(fwidth(distance_), 1e-6), 0.0, 1.0);
}
`;

/** A square about each sphere, on which a line of sight meets the sphere or passes by. */
export const sphereShaders = {
  vertex: `${view}
layout(location = 0) in vec4 ball;
layout(location = 1) in vec4 tint;
out vec2 place;
flat out vec3 pure;
flat out vec2 ahead;
void main() {
  vec3 centre = seen(ball.xyz);
  place = corner() * 1.05;
  pure = tint.rgb;
  ahead = vec2(centre.z, ball.w);
  gl_Position = any(greaterThan(ball.xyz, kept)) ? nowhere : onPicture(centre.xy + place * ball.w);
}`,
  fragment: `${shading}
in vec2 place;
flat in vec3 pure;
flat in vec2 ahead;
void main() {
  float off = length(place), edge = inside(off);
  if (edge <= 0.0) discard;
  vec3 normal = vec3(place, sqrt(max(0.0, 1.0 - off * off)));
  shade(normal, pure, ahead.x + ahead.y * normal.z, edge);
}`,
};

/** A strip about each line with round ends. */
export const lineShaders = {
  vertex: `${view}
layout(location = 0) in vec3 first;
layout(location = 1) in vec3 last;
layout(location = 2) in float radius;
layout(location = 3) in vec4 tint;
out vec2 place;
flat out vec3 pure;
flat out vec4 ahead;
void main() {
  vec3 a = seen(first), b = seen(last);
  float far = distance(a.xy, b.xy);
  vec2 along = far > 1e-4 * radius ? (b.xy - a.xy) / far : vec2(1.0, 0.0);
  vec2 side = corner() * 1.1;
  place = vec2(side.x < 0.0 ? side.x : far / radius + side.x, side.y);
  pure = tint.rgb;
  ahead = vec4(a.z, b.z, radius, far / radius);
  vec2 at = a.xy + radius * (place.x * along + place.y * vec2(-along.y, along.x));
  gl_Position = any(greaterThan(0.5 * (first + last), kept)) ? nowhere : onPicture(at);
}`,
  fragment: `${shading}
in vec2 place;
flat in vec3 pure;
flat in vec4 ahead;
void main() {
  float on = clamp(place.x, 0.0, ahead.w);
  vec2 off = vec2(place.x - on, place.y);
  float edge = inside(length(off));
  if (edge <= 0.0) discard;
  vec3 normal = vec3(0.0, off.y, sqrt(max(0.0, 1.0 - dot(off, off))));
  shade(normal, pure, mix(ahead.x, ahead.y, on / max(ahead.w, 1e-6)) + ahead.z * normal.z, edge);
}`,
};
