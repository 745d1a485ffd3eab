import { mapOf } from "../field/paint.js";
import { clips, makeScale } from "../field/scale.js";
import { bytes } from "../theme.js";

const beyondCodes = 0.001; // share of the voxels beyond each end of the codes

/** What colours follow from. */
export const painted = ["show", "component", "around", "law", "clip", "theme"];

/** The colour scale of what is shown, or null where the colours are names. */
export function scaleOf(result, state) {
  if (state.get("show") !== "field") return null;
  const key = painted.map((k) => state.get(k)).join(" ");
  if (result.scaleKey !== key) Object.assign(result, { scaleKey: key, keptScale: newScale(result, state) });
  return result.keptScale;
}

function newScale(result, state) {
  const name = state.get("component"),
    { magnitude, mean, low, high, least, most } = result.quantity(name),
    order = result.order(name),
    clip = clips[state.get("clip")];
  const around = magnitude && state.get("around") !== "ends" ? "ends" : state.get("around");
  const scale = makeScale(order, {
    around,
    symlog: state.get("law") === "symlog",
    clip: clip > beyondCodes ? clip : 0,
    mean,
  });
  const below = least < low && scale.low >= low ? beyondCodes : 0,
    above = most > high && scale.high <= high ? beyondCodes : 0;
  return {
    ...scale,
    below: Math.max(scale.below, below),
    above: Math.max(scale.above, above),
    order,
    mean,
    name,
  };
}

/** For every voxel the row of the table that has its colour. */
export const indexOf = (result, state) =>
  state.get("show") === "field" ? result.codes(state.get("component")) : result.phase;

/** The colours as 256 times RGBA. */
export function tableOf(result, state, theme) {
  const scale = scaleOf(result, state),
    table = new Uint8Array(1024);
  const colours = scale
    ? [theme.field.empty, ...Array.from({ length: 255 }, (_, k) => colourOf(result, scale, theme, k + 1))]
    : theme.kind;
  colours.forEach((colour, k) => table.set([...bytes(colour), 255], 4 * k));
  return table;
}

function colourOf(result, scale, theme, code) {
  const place = scale.of(result.valueOfCode(scale.name, code));
  return mapOf(theme, scale)(Math.min(1, Math.max(0, place)));
}
