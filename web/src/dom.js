/** An HTML element: h("p", { class: "note", onclick: f }, "text", child, [more]). Attributes that are null are left out. */
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

/** HTML text with "_{...}" lowered and "^{...}" raised: "σ_{norm}". */
export function rich(text) {
  return String(text)
    .split(/([_^]\{[^}]*\})/)
    .filter(Boolean)
    .map((part) => {
      if (part.startsWith("_{")) return h("sub", {}, part.slice(2, -1));
      return part.startsWith("^{") ? h("sup", {}, part.slice(2, -1)) : part;
    });
}

/** The text without what lowers and raises. */
export const plain = (text) => String(text).replace(/[_^]\{([^}]*)\}/g, "$1");

/** The same inside an SVG: every <text> with "_{...}", whole or in parts, gets lowered tspans. */
export function richSvg(svg) {
  for (const text of svg.querySelectorAll("text, tspan")) {
    for (const node of [...text.childNodes]) {
      if (node.nodeType !== Node.TEXT_NODE || !node.data.includes("_{")) continue;
      const parts = node.data.split(/(_\{[^}]*\})/).filter(Boolean);
      let lowered = false;
      node.replaceWith(
        ...parts.map((part) => {
          if (part.startsWith("_{")) {
            lowered = true;
            return s("tspan", { dy: "0.28em", "font-size": "76%" }, part.slice(2, -1));
          }
          const back = lowered ? "-0.21em" : null;
          lowered = false;
          return s("tspan", { dy: back }, part);
        }),
      );
    }
  }
  return svg;
}
