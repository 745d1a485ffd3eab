import { h, rich } from "./dom.js";
import { knownQuantities, topOf, valuesOf } from "./quantities.js";
import { isPresent } from "./sample.js";
import { fileName, saveText } from "./save.js";
import { prefixOf, text } from "./text.js";

const rowHeight = 25,
  spare = 8; // px; rows beyond either end of what is seen

/** A column: head, unit as shown and its SI one, and the value of a grain. */
function columnsOf(sample, noun) {
  const names = [
    { key: "id", head: noun, unit: "", si: "", factor: 1, of: () => (g) => sample.id[g], write: String },
    {
      key: "material",
      head: "material",
      unit: "",
      si: "",
      factor: 1,
      of: () => (g) => sample.materialName(g),
      write: String,
    },
  ];
  return [
    ...names,
    ...knownQuantities(sample).map(([key, { symbol, label, unit: si }]) => {
      const { factor, unit } = prefixOf(topOf(key, sample), si);
      return {
        key,
        head: symbol,
        label,
        unit,
        si,
        factor,
        write: (v) => (key === "coordination" ? String(v) : text.number(v / factor)),
        of: (snapshot) => {
          const values = valuesOf(key, sample, snapshot);
          return (g) => values[g];
        },
      };
    }),
  ];
}

/** All grains of the state that is shown with their numbers, in a table that is sorted by a click on a column header;
    only the rows in sight are made. A click on a row selects its grain everywhere, arrows go from row to row. `noun`:
    what a grain is called; `states`: of which states they are counted; `symbols`: what they mean, a sentence; `file`:
    how the name of a saved one begins. */
export function grainTable(sample, state, { noun, states, symbols, file }) {
  const columns = columnsOf(sample, noun),
    title = `${noun[0].toUpperCase()}${noun.slice(1)}s`,
    sorting = { column: columns[0], down: false };
  const scroller = h("div", {
    class: "scroller grains-rows",
    tabindex: 0,
    role: "region",
    "aria-label": `${title}; arrow keys move from row to row`,
  });
  const body = h("tbody"),
    before = h("tr", { class: "gap", "aria-hidden": "true" }, h("td")),
    after = before.cloneNode(true);
  let order = [],
    values = [];

  const sort = () => {
    const of = columns.map(({ of: value }) => value(sample.snapshot(state.get("snapshot")))),
      by = of[columns.indexOf(sorting.column)];
    const sign = sorting.down ? -1 : 1,
      compare = sorting.column.key === "material" ? (a, b) => a.localeCompare(b) : (a, b) => a - b;
    values = of;
    const here = sample.snapshot(state.get("snapshot"));
    const present = Array.from({ length: sample.count }, (_, g) => g).filter((g) => isPresent(here, g));
    order = present.sort((a, b) => sign * compare(by(a), by(b)) || a - b);
    heads.forEach((head, k) =>
      head.setAttribute(
        "aria-sort",
        columns[k] !== sorting.column ? "none" : sorting.down ? "descending" : "ascending",
      ),
    );
    draw();
  };
  const heads = columns.map((column) =>
    h(
      "th",
      { scope: "col" },
      h(
        "button",
        {
          title: column.label ?? null,
          onclick: () => {
            sorting.down =
              sorting.column === column ? !sorting.down : column.si !== "" || column.key === "coordination";
            sorting.column = column;
            scroller.scrollTop = 0;
            sort();
          },
        },
        rich(column.head),
        column.unit && h("small", {}, `, ${column.unit}`),
      ),
    ),
  );

  const row = (g) =>
    h(
      "tr",
      {
        "data-grain": g,
        "aria-selected": String(g === state.get("selected")),
        onclick: () => state.set({ selected: g === state.get("selected") ? null : g }),
        onpointerenter: () => state.set({ pointed: g }),
      },
      columns.map(({ write }, k) => h("td", {}, write(values[k](g)))),
    );
  const draw = () => {
    const first = Math.max(0, Math.floor(scroller.scrollTop / rowHeight) - spare);
    const last = Math.min(order.length, first + Math.ceil((scroller.clientHeight || 400) / rowHeight) + 2 * spare);
    before.firstChild.style.height = `${first * rowHeight}px`;
    after.firstChild.style.height = `${(order.length - last) * rowHeight}px`;
    body.replaceChildren(before, ...order.slice(first, last).map(row), after);
  };
  const show = () => {
    const at = order.indexOf(state.get("selected")) * rowHeight;
    if (at >= 0 && (at < scroller.scrollTop || at > scroller.scrollTop + scroller.clientHeight - 3 * rowHeight))
      scroller.scrollTop = Math.max(0, at - scroller.clientHeight / 2);
    draw();
  };
  scroller.addEventListener("scroll", draw, { passive: true });
  scroller.addEventListener("pointerleave", () => state.set({ pointed: null }));
  scroller.addEventListener("keydown", (event) => {
    const way = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!way) return;
    event.preventDefault();
    const at = order.indexOf(state.get("selected"));
    state.set({ selected: order[Math.min(order.length - 1, Math.max(0, at + way))] });
  });
  state.watch(["snapshot"], sort);
  state.watch(["selected"], show);
  scroller.append(h("table", {}, h("thead", {}, h("tr", {}, heads)), body));
  sort();
  if (state.get("selected") !== null) requestAnimationFrame(show);

  const csv = () => {
    const lines = [
      columns.map(({ key, si }) => (si ? `${key}_${si.replace("/", "_")}` : key)).join(","),
      ...order.map((g) => values.map((of) => of(g)).join(",")),
    ];
    saveText(
      `${fileName(...file, `${noun}s`, String(state.get("snapshot") + 1))}.csv`,
      "text/csv",
      `${lines.join("\n")}\n`,
    );
  };
  return h(
    "section",
    { class: "card numbers grain-table", "aria-label": title },
    h(
      "div",
      { class: "title" },
      h("h3", {}, title),
      h(
        "span",
        { class: "saves" },
        h(
          "button",
          { class: "save", "data-save": "csv", "aria-label": `Save the table of ${noun}s as CSV`, onclick: csv },
          "CSV",
        ),
      ),
    ),
    scroller,
    h(
      "p",
      { class: "caption" },
      rich(
        `${text.count(sample.count)} ${noun}s in ${states}; click a column header to sort, ` +
          `click a row to mark the ${noun} in the picture and the charts. ${symbols}The CSV file is in SI units.`,
      ),
    ),
  );
}
