import { h } from "./dom.js";

/** The loads of a stage beside those asked for, and what is to be doubted about it. */
const remarks = (stage) => [
  ...(stage.loads ?? []).map((load) => h("div", {}, load)),
  ...(stage.doubts ?? []).map((doubt) => h("div", { class: "doubt" }, `Warning: ${doubt}`)),
];

/** What made the numbers: version, seed, kernel, hashes, how each stage ended, and the resolved recipe. */
export function provenance(stages) {
  const last = stages.at(-1)?.provenance ?? {};
  const facts = [
    ["Arenite", last.version],
    ["seed", last.seed],
    ["kernel", last.kernel],
    ...Object.entries(last.options ?? {}),
  ].filter(([, value]) => value !== undefined && value !== "");
  return h(
    "footer",
    {},
    h(
      "dl",
      { class: "facts" },
      facts.map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, String(value)))),
    ),
    h(
      "table",
      {},
      h(
        "tbody",
        {},
        stages.map((stage) =>
          h(
            "tr",
            { class: stage.converged ? null : "unfinished" },
            h("td", {}, stage.name),
            h("td", {}, stage.outcome, remarks(stage)),
            h("td", { class: "hash" }, stage.provenance.input_hash),
          ),
        ),
      ),
    ),
    last.recipe ? h("details", {}, h("summary", {}, "Resolved recipe"), h("pre", {}, last.recipe)) : null,
  );
}
