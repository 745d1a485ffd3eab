const arrays = { f4: Float32Array, u1: Uint8Array, u2: Uint16Array, u4: Uint32Array, i4: Int32Array };

/** The bytes of a deflated text in base64. */
export async function inflate(base64) {
  const text = atob(base64.trim());
  const packed = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) packed[k] = text.charCodeAt(k);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The page's data: what the document says, and the block of numbers that it refers to. */
export async function loadData() {
  const document_ = await inflate(document.getElementById("document").textContent);
  return {
    about: JSON.parse(new TextDecoder().decode(document_)),
    block: await inflate(document.getElementById("numbers").textContent),
  };
}

/** The bytes of equal rank lie side by side in the block; here they go back to where they belong. The array has the
    unit that the document gives it. */
export function unpack(block, { at, n, as, unit = "" }) {
  const width = arrays[as].BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(n * width);
  for (let rank = 0; rank < width; ++rank)
    for (let k = 0; k < n; ++k) bytes[k * width + rank] = block[at + rank * n + k];
  return Object.assign(new arrays[as](bytes.buffer), { unit });
}

/** A tree whose arrays are in their place. */
export function unpacked(block, about) {
  if (about === null || typeof about !== "object") return about;
  if (Array.isArray(about)) return about.map((item) => unpacked(block, item));
  return about.as
    ? unpack(block, about)
    : Object.fromEntries(Object.entries(about).map(([name, value]) => [name, unpacked(block, value)]));
}

/** The drawings of one of the `figures` of a part, with their arrays in place, kept with it; undefined where it has
    none. */
export function opened(block, part, id) {
  if (!part?.figures?.[id]) return undefined;
  const kept = drawings.get(part.figures) ?? drawings.set(part.figures, {}).get(part.figures);
  return (kept[id] ??= filled(unpacked(block, part.figures[id])));
}

const drawings = new WeakMap();

/** What is not known is NaN in lists of numbers. */
function filled(tree) {
  if (Array.isArray(tree)) return tree.map((item) => (item === null ? NaN : filled(item)));
  if (tree === null || typeof tree !== "object" || ArrayBuffer.isView(tree)) return tree;
  return Object.fromEntries(Object.entries(tree).map(([name, value]) => [name, filled(value)]));
}
