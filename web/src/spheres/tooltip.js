import { materialColour } from "../theme.js";
import { text } from "../text.js";

/** The numbers of a sphere: place, radius, and the quantities that its state has. */
export function sphereNumbers(result, sphere, theme) {
  const { state } = result,
    material = state.material[sphere];
  const rows = [
    ["x, y, z", result.lengths(["x", "y", "z"].map((axis) => state[axis][sphere]))],
    ["radius", text.quantity(state.radius[sphere], "m")],
    ...Object.entries(state.quantities).map(([id, { label }]) => [label, result.written(id, sphere)]),
  ];
  const title = `Sphere ${state.id[sphere]}, ${result.materialName(sphere)}`;
  return { title, colour: materialColour(theme, material), rows };
}
