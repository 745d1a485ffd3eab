import { kindWords } from "../drawn.js";
import { text } from "../text.js";
import { empty } from "./result.js";

/** The numbers of the node under the pointer, and of the grain that it belongs to. */
export function nodeNumbers(result, node, theme, which) {
  const { map } = result,
    kind = map.kind[node],
    [x, y] = map.placeOf(node);
  const g = map.label[node] - 1;
  const rows = [["x, y", `${text.number(1e3 * x, 4)}, ${text.number(1e3 * y, 4)}\u202fmm`]];
  if (kind !== empty && result.loaded) rows.push(...stressRows(result, node));
  const cavities = map.cavities?.[which];
  if (cavities && cavities.label[node] > 0)
    rows.push(["size", `${text.count(cavities.nodes[cavities.label[node] - 1])} nodes`]);
  if (g >= 0) rows.push(...grainRows(result, g));
  return { title: g >= 0 ? `${nameOfKind(kind)} ${g + 1}` : nameOfKind(kind), colour: theme.kind[kind], rows };
}

/** As a title. */
export function nameOfKind(kind) {
  const words = kindWords(kind);
  return words[0].toUpperCase() + words.slice(1);
}

function stressRows(result, node) {
  const at = (id) => result.atNode(id, node),
    written = (id) => text.quantity(at(id), result.unitOf(id)),
    row = (id) => [result.quantity(id).symbol, written(id)],
    [against, relative] = result.relative(at);
  const rows = [
    ...["yy", "xx", "xy"].map(row),
    [result.quantity("principal").symbol, `${written("principal")} at ${Math.round(at("angle"))}\u00b0`],
    [against, text.number(relative)],
  ];
  if (result.has("travel")) rows.push(["u_{x}, u_{y}", `${written("ux")}, ${written("uy")}`]);
  return rows;
}

function grainRows(result, g) {
  const rows = [["grain\u2019s diameter", text.quantity(2 * result.radiusOfGrain(g), "m")]];
  if (result.loaded)
    rows.push(["grain\u2019s mean \u03c3_{yy}", text.quantity(result.ofGrain("yy", g), result.unitOf("yy"))]);
  return rows;
}
