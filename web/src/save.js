import { s } from "./dom.js";
import { passing } from "./figures/tips.js";

/** The text of an SVG that stands alone: namespaces, size, background and font are its own. */
export function svgText(svg, theme) {
  const copy = svg.cloneNode(true);
  const box = svg.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", box.width);
  copy.setAttribute("height", box.height);
  copy.setAttribute("font-family", theme.font);
  copy.setAttribute("color", theme.ink);
  copy.removeAttribute("class");
  copy.querySelectorAll(passing).forEach((node) => node.remove());
  copy.insertBefore(s("rect", { width: box.width, height: box.height, fill: theme.card }), copy.firstChild);
  return new XMLSerializer().serializeToString(copy);
}

function download(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

export function saveSvg(name, svg, theme) {
  download(`${name}.svg`, new Blob([svgText(svg, theme)], { type: "image/svg+xml" }));
}

export function saveText(name, type, content) {
  download(name, new Blob([content], { type }));
}

function loadImage(url) {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new Error("the browser could not draw the SVG"));
    image.src = url;
  });
}

/** Paints `under` (a canvas or nothing) and over it the SVG, `ratio` pixels a unit, and saves it as PNG. */
export async function savePng(name, svgSource, width, height, ratio, under = null) {
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  if (under) under(context, ratio);
  const image = await loadImage(`data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgSource)}`);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  download(`${name}.png`, blob);
}

export const fileName = (...parts) =>
  parts
    .join("-")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
