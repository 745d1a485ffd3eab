import { interpolateTurbo } from "d3-scale-chromatic";
import { packed } from "../theme.js";

export const cavityKinds = { voids: "Voids", pores: "Pores" };

/** A colour that neighbours in the list do not share: steps of the golden ratio around the circle. */
const anyColour = (k, dark) => interpolateTurbo(0.08 + 0.84 * ((k * 0.6180339887) % 1) * (dark ? 1 : 0.98));

/** [index, table] for every node: 0 elsewhere, 1 matrix, 2 grain, 3 left out of the statistics, then one a cavity. */
export function cavityColours(map, which, mode, theme) {
  const cavities = map.cavities[which];
  const soft =
    theme.name === "dark" ? ["#0a0c0e", "#33383d", "#24282c", "#4a5056"] : ["#ffffff", "#e6e3d8", "#d3d7da", "#b3b8bd"];
  const largest = Math.log(cavities.nodes.reduce((a, b) => Math.max(a, b), 2)),
    least = Math.log(Math.max(1, cavities.fewest_nodes));
  const bySize = (n) => theme.stress((Math.log(n) - least) / (largest - least || 1));
  const colours = Array.from(cavities.nodes, (n, k) =>
    mode === "size" ? bySize(n) : anyColour(k, theme.name === "dark"),
  );
  if (!cavities.index) {
    const hollow = (kind) => (which === "voids" ? kind === 0 : kind < 2);
    cavities.index = new Uint32Array(map.size);
    for (let k = 0; k < map.size; ++k) {
      const kind = map.kind[k];
      cavities.index[k] = cavities.label[k] > 0 ? 3 + cavities.label[k] : hollow(kind) ? 3 : kind === 1 ? 1 : 2;
    }
  }
  return [cavities.index, Uint32Array.from([...soft, ...colours].map(packed))];
}
