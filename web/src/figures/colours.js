import { drawn } from "../drawn.js";
import { materialLine } from "../theme.js";

const at = (list, k) => list[k % list.length];

/** Those of many lines in one chart; neighbours differ most. */
const lines = (theme) => [
  theme.materialLine[0],
  theme.materialLine[1],
  theme.mixedLine[0],
  theme.materialLine[3],
  theme.mixedLine[1],
  theme.weak,
  theme.strong,
];

const kindOf = (set) => drawn().kinds.findIndex(({ id }) => id === set);

/** The colour of a role, as descriptions of figures name them: "strong", "material 0", "set matrix". */
export function colourOf(theme, role) {
  const [name, which] = role.split(" ");
  if (name === "material") return materialLine(theme, Number(which));
  if (name === "mixed") return at(theme.mixedLine, Number(which));
  if (name === "line") return at(lines(theme), Number(which));
  if (name === "scale") return theme.size(Number(which));
  if (name === "source") return theme.accent;
  if (name === "set") return which === "all" ? theme.strong : theme.kindLine[kindOf(which)];
  return ["crack", "broken"].includes(name) ? theme[name][Number(which)] : theme[name];
}

/** How a line is broken. */
export const dashOf = (line) => ({ dashed: "6 3", dotted: "2 3" })[line] ?? null;
