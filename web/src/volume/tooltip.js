import { nameOfKind } from "../field/tooltip.js";
import { phases } from "./result.js";

/** The numbers of a voxel: phase, place, and the quantities, the one that is shown first. */
export function voxelNumbers(result, cell, theme, shown) {
  const voxel = result.voxelAt(cell),
    phase = result.phase[voxel];
  const rows = [["x, y, z", result.lengths(cell.map((c) => result.place(c)))]];
  const ids = [shown, ...result.offered.filter((id) => id !== shown)].filter((id) => result.offered.includes(id));
  if (phase !== phases.empty) rows.push(...ids.map((id) => [result.quantity(id).symbol, result.written(id, voxel)]));
  return { title: nameOfKind(phase), colour: theme.kind[phase], rows };
}
