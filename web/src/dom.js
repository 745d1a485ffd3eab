/** An HTML element: h("p", { class: "note", onclick: f }, "text", child, [more]). Attributes that are null are left
    out. */
export function h(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** The same for SVG. */
export function s(tag, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(3).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** A line of text in an SVG whose middle is as high as y. */
export const label = (x, y, words, anchor = null, more = {}) =>
  s("text", { x, y, dy: "0.35em", "text-anchor": anchor, ...more }, words);

let notation = /$^/g;

/** How quantities are written is one thought of the program's (`report/figures/drawing.hpp`): the page's data hold it
    as a regular expression, whose groups are the letter before an index, the mark and the index. */
export function readNotation(pattern) {
  notation = new RegExp(pattern, "g");
}

/** [words | { letter, mark, index }] of a text such as "mean σ_{norm}". */
function parts(text) {
  const found = [];
  let at = 0;
  for (const match of text.matchAll(notation)) {
    const [all, letter = "", mark, index] = match;
    found.push(text.slice(at, match.index), { letter, mark, index });
    at = match.index + all.length;
  }
  return [...found, text.slice(at)].filter((part) => part !== "");
}

/** HTML text of it: letters with an index are quantities, in italics. */
export function rich(text) {
  return parts(String(text)).map((part) =>
    typeof part === "string"
      ? part
      : [part.letter && h("i", {}, part.letter), h(part.mark === "_" ? "sub" : "sup", {}, part.index)],
  );
}

/** The text without what lowers and raises. */
export const plain = (text) => String(text).replace(notation, "$1$3");

const shifts = { _: [0.28, -0.21], "^": [-0.45, 0.34] }; // em of the index, and back in em of what follows

/** The same inside an SVG: in every <text>, whole or in parts, quantities become tspans. */
export function richSvg(svg) {
  for (const text of svg.querySelectorAll("text, tspan"))
    for (const node of [...text.childNodes])
      if (node.nodeType === Node.TEXT_NODE && /[_^]\{/.test(node.data)) node.replaceWith(...spansOf(node.data));
  return svg;
}

function spansOf(text) {
  let back = null;
  return parts(text).flatMap((part) => {
    const dy = back && `${back}em`;
    back = null;
    if (typeof part === "string") return [s("tspan", { dy }, part)];
    const [shift, after] = shifts[part.mark];
    const letter = part.letter && s("tspan", { dy, "font-style": "italic" }, part.letter);
    const offset = !letter && dy ? 1.32 * parseFloat(dy) : 0; // an index behind an index, in em of the smaller type
    back = after;
    const at = { dy: `${(shift + offset).toFixed(2)}em`, "font-size": "76%" };
    return [letter, s("tspan", at, part.index)].filter(Boolean);
  });
}
