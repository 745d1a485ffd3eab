import { h, rich } from "./dom.js";

/** One of the numbers that one asks for first: its name and symbol, and below them what it is. */
export function tile(name, symbol, ...value) {
  return h("div", { class: "tile" }, h("p", {}, name, symbol && [" ", h("i", {}, rich(symbol))]), h("strong", {}, value));
}
