// What the tests of the page of a packing look at it by.
import { rgb } from "../run.mjs";

export const click = (page, group, value) => page.click(`[data-choice="${group}"] [data-value="${value}"]`);

/** Place of grain g on the page, its radius in pixels, and its material. */
export const grain = (page, g) =>
  page.evaluate((k) => {
    const { view, sample } = window.arenite,
      box = view.canvas.getBoundingClientRect();
    const [x, y] = view.camera.toScreen(view.snapshot.x[k], view.snapshot.y[k]);
    return {
      x: x + box.left,
      y: y + box.top,
      radius: sample.radius[k] * view.camera.scale,
      material: sample.material[k],
      id: sample.id[k],
    };
  }, g);

/** Middle of the strongest chain between two grains of these types, and what it says. */
export const chain = (page, pick) =>
  page.evaluate((which) => {
    const { view, sample } = window.arenite,
      box = view.canvas.getBoundingClientRect(),
      { snapshot } = view;
    const { i, j, fn } = snapshot.contacts;
    const inside = [...fn.keys()].filter((c) => j[c] < sample.count && (which === "tension" ? fn[c] < 0 : fn[c] > 0));
    const c = inside.reduce((best, k) => (Math.abs(fn[k]) > Math.abs(fn[best]) ? k : best));
    const [x, y] = view.camera.toScreen(
      (snapshot.x[i[c]] + snapshot.x[j[c]]) / 2,
      (snapshot.y[i[c]] + snapshot.y[j[c]]) / 2,
    );
    return { x: x + box.left, y: y + box.top, ids: [sample.id[i[c]], sample.id[j[c]]], fn: fn[c] };
  }, pick);

export const light = {
  page: rgb("#f6f5f2"),
  card: rgb("#ffffff"),
  materials: [rgb("#5b8fc9"), rgb("#f0b44c")],
  strong: rgb("#14191f"),
  tension: rgb("#d81b60"),
};
