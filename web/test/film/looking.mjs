// What the tests of the page of a film look at it by.
import { settle } from "../run.mjs";

export const set = (page, changes) => page.evaluate((values) => window.arenite.film.state.set(values), changes);

export const show = async (page, changes) => {
  await set(page, {
    map: "in_phase",
    law: "linear",
    clip: "1",
    grains: "off",
    forces: false,
    motion: false,
    ...changes,
  });
  await page.mouse.move(2, 2);
  await settle(page);
};

export const tab = async (page, title) => {
  await page.click(`.tabs button:text-is("${title}")`);
  await settle(page);
};

/** A point of the film (column, row) on the page. */
export const onPage = (page, x, y) =>
  page.evaluate(
    ([column, row]) => {
      const { view } = window.arenite.film,
        box = view.canvas.getBoundingClientRect(),
        [px, py] = view.camera.toScreen(column, -row);
      return { x: px + box.left, y: py + box.top };
    },
    [x, y],
  );

/** Grains with all that the page knows of them. */
export const grains = (page) =>
  page.evaluate(() => {
    const { film } = window.arenite.film,
      { x, y, radius, material, id } = film.grains;
    return Array.from(x, (_, g) => ({
      g,
      x: x[g],
      y: y[g],
      radius: radius[g],
      material: material[g],
      id: id[g],
      norm: film.stresses.film.sigma_norm[g],
    }));
  });

/** Contacts between grains. */
export const contacts = (page) =>
  page.evaluate(() => {
    const { film } = window.arenite.film,
      { fn, fn_error: error, j } = film.contacts;
    return Array.from(fn, (f, c) => ({
      c,
      fn: f,
      error: error[c],
      ends: film.endsOf(c),
      uncertain: film.isUncertain(c),
    })).filter(({ c }) => j[c] < film.count);
  });

export const brightness = (colour) => (colour[0] + colour[1] + colour[2]) / 3;
