export const vertex = `#version 300 es
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;

/** A line of sight from every pixel, followed from face to face of the voxels until it meets one that is seen. Faces of
    the box have the colours of the scale, nearly unshaded; inside, what is seen is shaded by the gradient of how much
    of the neighbourhood is seen, and darker in hollows. */
export const fragment = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler3D;
uniform sampler3D phase, index, solid;
uniform sampler2D table;
uniform vec3 size, kept, right, up, towards, card;
uniform vec2 middle, canvas, seen;
uniform float perPixel, glow;
uniform int finer;
out vec4 colour;

int at(sampler3D field, ivec3 cell) {
  return int(texelFetch(field, cell, 0).r * 255.0 + 0.5);
}

float filling(vec3 place) {
  return texture(solid, place / size).r;
}

vec3 shaded(ivec3 cell, vec3 place, vec3 face, bool isCut) {
  vec3 pure = texelFetch(table, ivec2(at(index, cell), 0), 0).rgb;
  vec3 light = normalize(0.25 * right + 0.62 * up + 0.74 * towards);
  if (isCut) return pure * mix(0.9, 1.0, clamp(1.3 * dot(face, light), 0.0, 1.0));
  vec3 slope = vec3(
    filling(place + vec3(1.2, 0, 0)) - filling(place - vec3(1.2, 0, 0)),
    filling(place + vec3(0, 1.2, 0)) - filling(place - vec3(0, 1.2, 0)),
    filling(place + vec3(0, 0, 1.2)) - filling(place - vec3(0, 0, 1.2)));
  vec3 normal = normalize(mix(face, -slope / max(length(slope), 1e-4), clamp(6.0 * length(slope), 0.0, 0.9)));
  float hollow = filling(place + 2.5 * normal) + 0.6 * filling(place + 5.0 * normal);
  float bright = 0.58 + 0.5 * max(dot(normal, light), 0.0);
  return pure * min(1.0, bright) * (1.0 - 0.26 * clamp(hollow, 0.0, 1.5)) + glow * (bright - 0.58);
}

vec3 look(vec2 point) {
  vec2 uv = (point - 0.5 * canvas) * perPixel + middle;
  vec3 start = 0.5 * size + uv.x * right + uv.y * up + length(size) * towards;
  vec3 way = -towards;
  way = mix(way, vec3(1e-6), vec3(lessThan(abs(way), vec3(1e-6))));
  vec3 a = -start / way, b = (kept - start) / way;
  vec3 near = min(a, b), far = max(a, b);
  float t = max(near.x, max(near.y, near.z));
  if (t >= min(far.x, min(far.y, far.z))) return card;
  vec3 turn = sign(way), stride = abs(1.0 / way);
  vec3 face = t == near.x ? vec3(-turn.x, 0, 0) : t == near.y ? vec3(0, -turn.y, 0) : vec3(0, 0, -turn.z);
  ivec3 cell = clamp(ivec3(floor(start + way * (t + 1e-4))), ivec3(0), ivec3(kept) - 1), end = ivec3(kept);
  vec3 next = (vec3(cell) + max(turn, 0.0) - start) / way;
  bool isCut = true;
  int most = end.x + end.y + end.z;
  for (int k = 0; k < most; ++k) {
    int what = at(phase, cell);
    if ((what == 1 && seen.x > 0.5) || (what == 2 && seen.y > 0.5))
      return shaded(cell, start + way * t, face, isCut);
    isCut = false;
    if (next.x <= next.y && next.x <= next.z) {
      t = next.x; next.x += stride.x; cell.x += int(turn.x); face = vec3(-turn.x, 0, 0);
      if (cell.x < 0 || cell.x >= end.x) break;
    } else if (next.y <= next.z) {
      t = next.y; next.y += stride.y; cell.y += int(turn.y); face = vec3(0, -turn.y, 0);
      if (cell.y < 0 || cell.y >= end.y) break;
    } else {
      t = next.z; next.z += stride.z; cell.z += int(turn.z); face = vec3(0, 0, -turn.z);
      if (cell.z < 0 || cell.z >= end.z) break;
    }
  }
  return card;
}

void main() {
  vec3 sum = vec3(0);
  for (int k = 0; k < finer * finer; ++k) {
    vec2 part = (vec2(k % finer, k / finer) + 0.5) / float(finer) - 0.5;
    sum += look(gl_FragCoord.xy + part);
  }
  colour = vec4(sum / float(finer * finer), 1.0);
}`;
