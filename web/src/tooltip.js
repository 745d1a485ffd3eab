import { h, rich } from "./dom.js";
import { drawn } from "./drawn.js";
import { boundaryElement } from "./packing/chains.js";
import { materialColour, pairColour } from "./theme.js";
import { text } from "./text.js";

/** The numbers of a grain or a contact, in a small table that follows the pointer. */
export class Tooltip {
  constructor(holder) {
    this.holder = holder;
    this.box = h("div", { class: "tooltip", role: "status", hidden: true });
    holder.append(this.box);
  }

  hide() {
    this.box.hidden = true;
  }

  show(picked, sample, snapshot, theme, [px, py]) {
    const numbers =
      picked.grain !== undefined
        ? grainNumbers(picked.grain, sample, snapshot, theme)
        : contactNumbers(picked.contact, sample, snapshot, theme);
    this.write(numbers, [px, py]);
  }

  /** Rows = [name, value]; beside the point, inside the holder. */
  write({ title, colour, rows }, [px, py]) {
    this.box.replaceChildren(
      h("p", {}, h("span", { class: "dot", style: `background:${colour}` }), title),
      h(
        "dl",
        {},
        rows.map(([name, value]) => [h("dt", {}, rich(name)), h("dd", {}, value)]),
      ),
    );
    this.box.hidden = false;
    const width = this.box.offsetWidth,
      height = this.box.offsetHeight;
    const left = px + 18 + width > this.holder.clientWidth ? px - width - 14 : px + 18;
    this.box.style.left = `${Math.max(2, left)}px`;
    this.box.style.top = `${Math.max(2, Math.min(py + 14, this.holder.clientHeight - height - 2))}px`;
  }
}

function grainNumbers(g, sample, snapshot, theme) {
  const rows = [
    ["diameter", text.millimetres(2 * sample.radius[g])],
    ["\u03c3_{hyd}", text.quantity(-snapshot.pressure[g], snapshot.pressure.unit)],
    ["\u03c3_{norm}", text.number(snapshot.sigmaNorm[g])],
    ["contacts z", String(snapshot.coordination[g])],
  ];
  if (sample.zone[g]) rows.push(["zone", String(sample.zone[g])]);
  const title = `Grain ${sample.id[g]}, ${sample.materialName(g)}`;
  return { title, colour: materialColour(theme, sample.material[g]), rows };
}

/** A wall, or behind the four of them a boundary by the number of its element. */
function sideName(snapshot, side) {
  return side > 3
    ? boundaryElement(snapshot, side - 4).boundary.name
    : `${drawn().sides[side]} wall`;
}

function contactNumbers(c, sample, snapshot, theme) {
  const { i, j, fn, ft, type, glued } = snapshot.contacts;
  const kind = sample.types[type[c]];
  const partner = kind.wall ? sideName(snapshot, j[c] - sample.count) : String(sample.id[j[c]]);
  const rows = [
    ["F_{n}", text.quantity(fn[c], fn.unit)],
    ["F_{t}", text.quantity(ft[c], ft.unit)],
    ["F_{n}/\u27e8F_{n}\u27e9", text.number(fn[c] / snapshot.meanForce)],
    ["|F_{t}|/F_{n}", text.number(Math.abs(ft[c] / fn[c]), 2)],
  ];
  if (glued[c]) rows.push(["glue", "holds"]);
  return {
    title: `Contact ${sample.id[i[c]]}\u2013${partner}${kind.wall ? "" : `, ${kind.label}`}`,
    colour: pairColour(theme, kind),
    rows,
  };
}
