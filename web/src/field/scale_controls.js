import { choice } from "../choice.js";

/** Shows an element only while `fits` what is shown. */
export function only(state, fits, element) {
  const refresh = () => {
    element.hidden = !fits(state.get("show"));
  };
  state.watch(["show"], refresh);
  refresh();
  return element;
}

export const isField = (show) => show === "field";

/** Which of its quantities are painted. */
export const componentChoice = (result, state) =>
  choice(
    "",
    "component",
    state,
    result.offered.map((id) => [id, result.quantity(id).symbol]),
  );

/** How values become colours; `clips` are the shares beyond the ends of the scale that may be chosen first. */
export const scaleChoices = (state, clips = []) => [
  choice("Centre", "around", state, [
    ["mean", "Mean"],
    ["zero", "0"],
    ["ends", "None"],
  ]),
  choice("", "law", state, [
    ["linear", "Linear"],
    ["symlog", "Symlog"],
  ]),
  choice("Clip", "clip", state, [...clips, ["0.1", "0.1"], ["1", "1"], ["5", "5\u202f%"]]),
];
