import { h } from "../dom.js";
import { prefixOf, text } from "../text.js";
import { tile } from "../tile.js";
import { classes } from "./result.js";

/** The numbers that one asks for first: of the sample always, of its response where it was loaded. */
export function fieldHeadlines(result) {
  const { map } = result, [empty, matrix, particle] = map.about.nodes, all = empty + matrix + particle;
  const percent = (share) => [text.number(100 * share, 3), "%"];
  const tiles = [["grains", "\u03c1_{p}", percent(particle / all)], ["matrix in the pores", "S_{m}", percent(matrix / Math.max(1, all - particle))], ["void", "\u03c1_{v}", percent(empty / all)]];
  if (result.steps > 1) tiles.push(...failure(result));
  else if (result.loaded) tiles.push(...response(result));
  return h("div", { class: "headlines" }, tiles.map(([name, symbol, [value, unit]]) => tile(name, symbol, value, unit && h("small", {}, `\u202f${unit}`))));
}

function quantity(value, unit) {
  const { factor, prefix } = prefixOf(Math.abs(value), unit);
  return [text.number(value / factor, 4), prefix + unit];
}

/** As the program reports it, without what clamps hold. */
function statedMean(result) {
  const stated = result.statistics?.sigma_yy?.sample_mean_Pa;
  return stated?.value ?? stated ?? result.mean;
}

function response(result) {
  const { components } = result.about;
  const mean = (kind) => {
    const { grainClass } = result.map, { nodes, yy } = result.grains;
    let sum = 0, count = 0;
    for (let g = 0; g < nodes.length; ++g) if (classes.particle + grainClass[g] === kind) [sum, count] = [sum + nodes[g] * yy[g], count + nodes[g]];
    return count ? sum / count / result.mean : NaN;
  };
  const known = [["in large grains", classes.large], ["in small grains", classes.small], ["in grains", classes.particle]]
    .map(([name, kind]) => [name, "\u27e8\u03c3_{yy}\u27e9/\u27e8\u03c3_{yy}\u27e9_{all}", [text.number(mean(kind), 3), ""]]).filter(([, , [value]]) => value !== "\u2013");
  const largest = ["largest stress over mean", "\u03c3_{yy}", [text.number(components.yy.most / result.mean, 3), ""]];
  return [...modulus(result), ["mean stress", "\u27e8\u03c3_{yy}\u27e9", quantity(statedMean(result), "Pa")], ...known, largest].slice(0, 3);
}

function failure(result) {
  const stress = Array.from(result.curve.stress.values), strain = result.curve.strain.values;
  const peak = stress.indexOf(Math.max(...stress));
  return [...modulus(result), ["strength", "", quantity(stress[peak], "Pa")], ["strain at peak stress", "", [text.number(1e3 * strain[peak], 3), "\u2030"]],
    ["broken bonds", "", [text.count(result.cracks ? result.cracks.x.length : 0), ""]]].slice(0, 3);
}

/** Of the loaded axis, where it was measured. */
function modulus({ numbers }) {
  const stated = numbers?.modulus_Pa?.value ?? numbers?.modulus_Pa;
  return stated > 0 ? [["modulus", "E", quantity(stated, "Pa")]] : [];
}
