import { clips, makeScale, usualClip } from "../field/scale.js";
import { bytes, packed } from "../theme.js";
import { faintness } from "./maps.js";

const shades = 512;
const circle = {
  low: -180,
  high: 180,
  centre: null,
  symlog: false,
  below: 0,
  above: 0,
  of: (v) => (v + 180) / 360,
  value: (t) => 360 * t - 180,
};

/** The colour scale of the map that is shown, with its values in order; a film keeps the last one. */
export function scaleOf(film, state) {
  const name = state.get("map"),
    key = [name, state.get("law"), state.get("clip")].join(" ");
  if (film.scaleKey === key) return film.keptScale;
  film.orders ??= new Map();
  if (!film.orders.has(name)) film.orders.set(name, film.values(name).filter(Number.isFinite).sort());
  const order = film.orders.get(name),
    { cyclic, around, ends } = film.about.maps[name],
    clip = state.get("clip");
  film.scaleKey = key;
  return (film.keptScale = {
    ...(cyclic
      ? circle
      : makeScale(order, {
          around,
          symlog: state.get("law") === "symlog",
          clip: clips[clip],
          mean: 0,
          ends: clip === usualClip("pixels") ? ends : undefined,
        })),
    order,
    name,
  });
}

/** The map as a canvas, one pixel a pixel. */
export function painted(film, state, theme) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: film.width, height: film.height });
  const name = state.get("map"),
    scale = scaleOf(film, state),
    values = film.values(name),
    { colours, cyclic, marks } = film.about.maps[name],
    palette = theme.scales[colours];
  const table = Uint32Array.from({ length: shades }, (_, k) => packed(palette((k + 0.5) / shades))),
    none = packed(theme.field.aside);
  const faint = cyclic && faintness(film),
    pale = faint && table.map((_, k) => packed(mixed(palette((k + 0.5) / shades), theme.card)));
  const out = new Uint32Array(values.length);
  for (let k = 0; k < out.length; ++k) {
    const shade = Math.min(shades - 1, Math.max(0, Math.floor(scale.of(values[k]) * shades)));
    out[k] = Number.isNaN(values[k]) ? none : faint && faint(k) ? pale[shade] : table[shade];
  }
  if (marks) for (const k of film.bad) out[k] = packed(theme.badPixel);
  canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(out.buffer), film.width, film.height), 0, 0);
  return canvas;
}

function mixed(colour, background) {
  const to = bytes(background);
  return `rgb(${bytes(colour)
    .map((v, c) => Math.round(to[c] + 0.2 * (v - to[c])))
    .join(", ")})`;
}
