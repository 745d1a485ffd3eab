import { mapOf } from "../field/paint.js";
import { clips, makeScale } from "../field/scale.js";
import { bytes, materialColour } from "../theme.js";

const shades = 256;

/** What colours follow from. */
export const painted = ["show", "around", "law", "clip", "theme"];

/** The colour scale of what is shown, or null where the colours are names. */
export function scaleOf(result, state) {
  const name = state.get("show");
  if (name === "material") return null;
  const order = result.order(name),
    { mean, magnitude } = result.quantity(name),
    around = magnitude ? "ends" : state.get("around");
  const scale = makeScale(order, {
    around,
    symlog: state.get("law") === "symlog",
    clip: clips[state.get("clip")],
    mean,
  });
  return { ...scale, order, mean, name };
}

/** RGBA of every sphere. */
export function coloursOf(result, state, theme) {
  const scale = scaleOf(result, state),
    table = tableOf(result, scale, theme),
    colours = new Uint8Array(4 * result.count);
  const { material } = result.state,
    values = scale && result.state[scale.name];
  const row = scale
    ? (g) => Math.min(shades - 1, Math.max(0, Math.floor(scale.of(values[g]) * shades)))
    : (g) => material[g];
  for (let g = 0; g < result.count; ++g) colours.set(table[row(g)], 4 * g);
  return colours;
}

function tableOf(result, scale, theme) {
  const names = scale
    ? Array.from({ length: shades }, (_, k) => mapOf(theme, scale)((k + 0.5) / shades))
    : result.materials.map((_, m) => materialColour(theme, m));
  return names.map((colour) => [...bytes(colour), 255]);
}
