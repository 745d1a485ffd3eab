import { drawn } from "../drawn.js";
import { packed } from "../theme.js";
import { cavityColours } from "./cavities.js";
import { clips, makeScale, sorted, usualClip } from "./scale.js";

const shades = 512;

/** The colour scale of what is shown, or null where the colours are names. One for nodes and grains alike. */
export function scaleOf(result, state) {
  if (state.get("show") !== "field") return null;
  const name = state.get("component"),
    { magnitude } = result.quantity(name);
  const key = ["component", "around", "law", "clip"].map((k) => state.get(k)).join(" ");
  if (result.scaleKey === key) return result.keptScale;
  result.orders ??= new Map();
  if (!result.orders.has(name)) result.orders.set(name, sorted(result.values(name), result.map.kind));
  const order = result.orders.get(name);
  const { mean, ends } = result.quantity(name),
    clip = state.get("clip");
  const around = magnitude && state.get("around") !== "ends" ? "ends" : state.get("around");
  result.scaleKey = key;
  return (result.keptScale = {
    ...makeScale(order, {
      around,
      symlog: state.get("law") === "symlog",
      clip: clips[clip],
      mean,
      ends: clip === usualClip("nodes") ? ends : undefined,
    }),
    order,
    mean,
    name,
  });
}

export const mapOf = (theme, scale) =>
  theme.scales[scale.centre === null ? drawn().colours.one_sided : drawn().colours.centred];

/** Colours of all nodes as RGBA bytes, row by row from the bottom. */
export function paint(result, state, theme) {
  const show = state.get("show"),
    { map } = result;
  const out = new Uint32Array(map.size);
  if (show === "field") paintField(out, result, state, theme);
  else if (show === "phases") paintByTable(out, map.kind, theme.kind.map(packed));
  else paintByTable(out, ...cavityColours(map, show, state.get("cavities"), theme));
  return new Uint8Array(out.buffer);
}

function paintByTable(out, index, table) {
  for (let k = 0; k < out.length; ++k) out[k] = table[index[k]];
}

/** A threshold puts aside what carries less than so many times the mean: what is left are the stress chains. */
function paintField(out, result, state, theme) {
  const { map } = result,
    scale = scaleOf(result, state);
  const palette = mapOf(theme, scale),
    table = Uint32Array.from({ length: shades }, (_, k) => packed(palette((k + 0.5) / shades)));
  const empty = packed(theme.field.empty),
    aside = packed(theme.field.aside);
  const least = state.get("chains") ? state.get("threshold") * Math.abs(scale.mean) : 0;
  const shade = (v) =>
    Math.abs(v) < least ? aside : table[Math.min(shades - 1, Math.max(0, Math.floor(scale.of(v) * shades)))];
  const { kind, label } = map;
  if (state.get("by") === "grain" && result.grainsHave(scale.name)) {
    const table_ = Uint32Array.from({ length: map.grainKind.length + 1 }, (_, g) =>
      g === 0 ? aside : shade(result.ofGrain(scale.name, g - 1)),
    );
    for (let k = 0; k < out.length; ++k) out[k] = kind[k] === 0 ? empty : table_[label[k]];
    return;
  }
  const values = result.values(scale.name);
  for (let k = 0; k < out.length; ++k) out[k] = kind[k] === 0 ? empty : shade(values[k]);
}
