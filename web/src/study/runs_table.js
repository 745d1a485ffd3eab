import { h, plain, rich } from "../dom.js";
import { quoted } from "../figures/csv.js";
import { fileName, saveText } from "../save.js";
import { text } from "../text.js";

/** A number and its standard error: "0.124 \u00b1 0.029". */
function written(number) {
  if (!number) return "";
  const { value, error } = text.withError(number[0], number[1] ?? NaN);
  return [value, error && h("small", {}, ` \u00b1 ${error}`)];
}

/** Every run of the study with what was swept and its main numbers, sorted by a click on a column header; what a run
    was given leads to its page, or its name where nothing was swept. */
export function runsTable(title, { keys, names, rows }) {
  const sorting = { column: 0, down: false },
    body = h("tbody");
  const first = keys.length ? keys : ["run"],
    given = ({ run, values }) => (keys.length ? values : [run.slice(0, 8)]);
  const cells = (row) => [...given(row), row.status, ...row.numbers.map((number) => number?.[0] ?? NaN)];
  const order = (a, b) =>
    typeof a === "string" && (Number.isNaN(Number(a)) || Number.isNaN(Number(b)))
      ? a.localeCompare(b)
      : Number(a) - Number(b) || 0;
  const heads = [...first, "", ...names].map((head, k) =>
    h(
      "th",
      { scope: "col" },
      h(
        "button",
        {
          "aria-label": plain(head) || "status",
          onclick: () => {
            sorting.down = sorting.column === k && !sorting.down;
            sorting.column = k;
            draw();
          },
        },
        rich(head || "status"),
      ),
    ),
  );
  const draw = () => {
    const sorted = [...rows].sort(
      (a, b) => (sorting.down ? -1 : 1) * order(cells(a)[sorting.column], cells(b)[sorting.column]),
    );
    heads.forEach((head, k) =>
      head.setAttribute("aria-sort", k !== sorting.column ? "none" : sorting.down ? "descending" : "ascending"),
    );
    body.replaceChildren(
      ...sorted.map((row) =>
        h(
          "tr",
          { "data-run": row.run },
          given(row).map((value, k) =>
            h(
              "td",
              { title: k ? null : `run ${row.run}` },
              row.link && !k ? h("a", { href: row.link }, value || "\u2013") : value,
            ),
          ),
          h("td", {}, row.status),
          row.numbers.map((number) => h("td", {}, written(number))),
        ),
      ),
    );
  };
  const csv = () => {
    const lines = [
      ["run", "status", ...keys, ...names.map(plain).flatMap((name) => [name, `${name}, standard error`])],
      ...rows.map(({ run, status, values, numbers }) => [
        run,
        status,
        ...values,
        ...numbers.flatMap((n) => [n?.[0] ?? "", n?.[1] ?? ""]),
      ]),
    ];
    saveText(
      `${fileName(title, "runs")}.csv`,
      "text/csv",
      `${lines.map((line) => line.map((word) => quoted(String(word))).join(",")).join("\n")}\n`,
    );
  };
  draw();
  return h(
    "section",
    { class: "card numbers runs", "aria-label": "Runs" },
    h(
      "div",
      { class: "title" },
      h("h3", {}, "Runs"),
      h(
        "span",
        { class: "saves" },
        h(
          "button",
          { class: "save", "data-save": "csv", "aria-label": "Save the table of runs as CSV", onclick: csv },
          "CSV",
        ),
      ),
    ),
    h(
      "div",
      { class: "scroller grains-rows", tabindex: 0, role: "region", "aria-label": "Runs" },
      h("table", {}, h("thead", {}, h("tr", {}, heads)), body),
    ),
    h(
      "p",
      { class: "caption" },
      "Numbers of the last state of each run with their standard errors; arenite study collect writes all numbers.",
    ),
  );
}
