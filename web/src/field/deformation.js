const reach = 0.15; // of the sample's longer side, where the slider is at its end

/** { ux, uy: of every node, most: the largest of what is not void }, m. */
function displacementsOf(result) {
  return (result.displaced ??= (() => {
    const [ux, uy] = ["ux", "uy"].map((name) => result.values(name)),
      { kind } = result.map;
    let most = 0;
    const travel = result.values("travel");
    for (let k = 0; k < kind.length; ++k) if (kind[k] > 0) most = Math.max(most, travel[k]);
    return { ux, uy, most };
  })());
}

/** How many times displacements are drawn larger than they are, where the slider is at `share`; 0 where nothing is
    displaced. */
export function magnification(result, share) {
  const { most } = displacementsOf(result),
    { right, top } = result.map.box;
  return most > 0 ? (share * reach * Math.max(right, top)) / most : 0;
}

/** Where the node at a point went, drawn `times` larger. */
export function displacedBy(result, x, y, times) {
  const node = result.map.nodeAt(x, y),
    { ux, uy } = displacementsOf(result);
  return node === null ? [x, y] : [x + times * ux[node], y + times * uy[node]];
}

/** Box that holds the sample as it is drawn. */
export function displacedBox(result, times) {
  const { map } = result,
    { ux, uy } = displacementsOf(result),
    found = { ...map.box };
  for (let k = 0; k < map.size; ++k) {
    if (map.kind[k] === 0) continue;
    const [x, y] = map.placeOf(k),
      px = x + times * ux[k],
      py = y + times * uy[k];
    [found.left, found.right] = [Math.min(found.left, px), Math.max(found.right, px)];
    [found.bottom, found.top] = [Math.min(found.bottom, py), Math.max(found.top, py)];
  }
  return found;
}

/** Place and displacement of every node that is not void, for the graphics card, and which node each is. */
export function nodeBuffers(result, origin) {
  const { ux, uy } = displacementsOf(result),
    { map } = result,
    nodes = [];
  for (let k = 0; k < map.size; ++k) if (map.kind[k] > 0) nodes.push(k);
  const place = new Float32Array(2 * nodes.length),
    move = new Float32Array(2 * nodes.length);
  nodes.forEach((k, n) => {
    const [x, y] = map.placeOf(k);
    place.set([x - origin.x, y - origin.y], 2 * n);
    move.set([ux[k], uy[k]], 2 * n);
  });
  return { nodes: Uint32Array.from(nodes), place, move };
}

/** Draws nodes as squares where they went: where a crack opens nothing is left between them. */
export function deformedDrawing(regl) {
  return regl({
    vert: `
      precision highp float;
      attribute vec2 place, move;
      attribute vec4 colour;
      uniform vec2 middle, perMetre;
      uniform float times, size;
      varying vec3 paint;
      void main() {
        paint = colour.rgb;
        gl_PointSize = size;
        gl_Position = vec4((place + times * move - middle) * perMetre, 0.0, 1.0);
      }`,
    frag: `
      precision highp float;
      uniform vec3 background;
      uniform float fade;
      varying vec3 paint;
      void main() { gl_FragColor = vec4(mix(paint, background, fade), 1.0); }`,
    attributes: {
      place: regl.prop("place"),
      move: regl.prop("move"),
      colour: { buffer: regl.prop("colour"), type: "uint8", normalized: true },
    },
    uniforms: Object.fromEntries(
      ["middle", "perMetre", "times", "size", "background", "fade"].map((name) => [name, regl.prop(name)]),
    ),
    primitive: "points",
    count: regl.prop("count"),
    depth: { enable: false },
  });
}
