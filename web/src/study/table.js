import { h, rich } from "../dom.js";

/** A table of texts in a card; a row is {cells, marked}. Those of `more` show when they are asked for. */
export function plainTable({ title, caption, heads, rows, more = [] }) {
  const row = ({ cells, marked }) =>
    h(
      "tr",
      { class: marked ? "marked" : null },
      cells.map((cell) => h("td", {}, rich(cell))),
    );
  const table = (body) =>
    h(
      "div",
      { class: "scroller", tabindex: 0, role: "region", "aria-label": title },
      h(
        "table",
        {},
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heads.map((head) => h("th", { scope: "col" }, rich(head))),
          ),
        ),
        h("tbody", {}, body.map(row)),
      ),
    );
  return h(
    "section",
    { class: "card numbers runs", "aria-label": title },
    h("div", { class: "title" }, h("h3", {}, rich(title))),
    rows.length ? table(rows) : null,
    caption && h("p", { class: "caption" }, caption),
    more.length ? h("details", {}, h("summary", {}, `${more.length} more`), table(more)) : null,
  );
}
