export const vertex = `#version 300 es
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;

/** A line of sight from every pixel, followed from face to face of the voxels until it meets one that is seen. Faces of
    the box have the colours of the scale, nearly unshaded; inside, what is seen is shaded by the gradient of how much
    of the neighbourhood is seen, and darker in hollows. As a surface it ends where that is less than a share of one
    half, less a little so that walls of one voxel stay. */
export const fragment = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler3D;
uniform sampler3D seen, index, solid;
uniform sampler2D table;
uniform vec3 size, kept, right, up, towards, card, light;
uniform vec2 middle, canvas;
uniform float perPixel, glow;
uniform int finer;
uniform bool isSurface;
out vec4 colour;

int at(sampler3D field, ivec3 cell) {
  return int(texelFetch(field, cell, 0).r * 255.0 + 0.5);
}

float filling(vec3 place) {
  return texture(solid, place / size).r;
}

vec3 slopeAt(vec3 place) {
  return vec3(
    filling(place + vec3(1.2, 0, 0)) - filling(place - vec3(1.2, 0, 0)),
    filling(place + vec3(0, 1.2, 0)) - filling(place - vec3(0, 1.2, 0)),
    filling(place + vec3(0, 0, 1.2)) - filling(place - vec3(0, 0, 1.2)));
}

bool isSeen(ivec3 cell) {
  return texelFetch(seen, cell, 0).r > 0.0;
}

vec3 shaded(ivec3 cell, vec3 place, vec3 face, bool isCut) {
  vec3 pure = texelFetch(table, ivec2(at(index, cell), 0), 0).rgb;
  vec3 lit = light.x * right + light.y * up + light.z * towards;
  if (isCut) return pure * mix(0.9, 1.0, clamp(1.3 * dot(face, lit), 0.0, 1.0));
  vec3 slope = slopeAt(place);
  vec3 normal = normalize(mix(face, -slope / max(length(slope), 1e-4), clamp(6.0 * length(slope), 0.0, 0.9)));
  float hollow = filling(place + 2.5 * normal) + 0.6 * filling(place + 5.0 * normal);
  float bright = 0.58 + 0.5 * max(dot(normal, lit), 0.0);
  return pure * min(1.0, bright) * (1.0 - 0.26 * clamp(hollow, 0.0, 1.5)) + glow * (bright - 0.58);
}

const float rim = 0.45;

/** Where the line of sight from t to far meets the surface; below 0 if it does not. */
float crossing(vec3 start, vec3 way, float t, float far) {
  for (int k = 1; k <= 2; ++k) {
    float high = mix(t, far, 0.5 * float(k)), low = mix(t, far, 0.5 * float(k - 1));
    if (filling(start + way * high) <= rim) continue;
    for (int n = 0; n < 5; ++n) {
      float half_way = 0.5 * (low + high);
      if (filling(start + way * half_way) > rim) high = half_way; else low = half_way;
    }
    return high;
  }
  return -1.0;
}

/** The voxel that is seen right below a place of the surface, or else this one. */
ivec3 below(vec3 place, vec3 normal, ivec3 cell) {
  for (int k = 1; k <= 4; ++k) {
    ivec3 under = clamp(ivec3(floor(place - 0.4 * float(k) * normal)), ivec3(0), ivec3(kept) - 1);
    if (isSeen(under)) return under;
  }
  return cell;
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
  bool isCut = true, isMet = false;
  int most = end.x + end.y + end.z;
  for (int k = 0; k < most; ++k) {
    if (isSurface && !isCut) {
      float met = texelFetch(solid, cell, 0).r > 0.1 ? crossing(start, way, t, min(next.x, min(next.y, next.z))) : -1.0;
      isMet = met >= 0.0;
      if (isMet) t = met;
    } else isMet = isSeen(cell);
    if (isMet) break;
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
  if (!isMet) return card;
  vec3 place = start + way * t;
  if (isSurface && !isCut) {
    vec3 slope = slopeAt(place);
    face = -slope / max(length(slope), 1e-4);
    cell = below(place, face, cell);
  }
  return shaded(cell, place, face, isCut);
}

void main() {
  vec3 sum = vec3(0);
  for (int k = 0; k < finer * finer; ++k) {
    vec2 part = (vec2(k % finer, k / finer) + 0.5) / float(finer) - 0.5;
    sum += look(gl_FragCoord.xy + part);
  }
  colour = vec4(sum / float(finer * finer), 1.0);
}`;
