// What the tests of the page of a cemented sample look at it by.
import { rgb, settle } from "../run.mjs";

export const light = {
  kind: ["#ffffff", "#f4d27a", "#6e9fd0", "#2c5d9e", "#a6cbe9"].map(rgb),
  card: rgb("#ffffff"),
  empty: rgb("#ffffff"),
  aside: rgb("#d4d5d2"),
  crack: [null, "#7a1fa2", "#0b0d10", "#00796b"].map((c) => c && rgb(c)),
};

export const set = (page, changes) => page.evaluate((values) => window.arenite.field.state.set(values), changes);

export const tab = async (page, title) => {
  await page.click(`.tabs button:text-is("${title}")`);
  await settle(page);
};

/** Nodes inside of which nothing else is for three nodes around, some of each kind: place on the page, kind, numbers.
 */
export const places = (page, kinds) =>
  page.evaluate((wanted) => {
    const { view, result } = window.arenite.field,
      { map } = result,
      box = view.canvas.getBoundingClientRect();
    const found = [],
      missing = new Map(wanted.map((kind) => [kind, 4]));
    for (let tries = 0; tries < 200000 && [...missing.values()].some((n) => n > 0); ++tries) {
      const x = 3 + ((tries * 7919) % (map.width - 6)),
        y = 3 + ((tries * 104729) % (map.height - 6)),
        node = x + map.width * y,
        kind = map.kind[node];
      if (!(missing.get(kind) > 0)) continue;
      const reach = kind < 2 ? 1 : 2;
      let even = true;
      for (let j = -reach; j <= reach; ++j)
        for (let i = -reach; i <= reach; ++i)
          even &&=
            map.label[node + i + map.width * j] === map.label[node] && map.kind[node + i + map.width * j] === kind;
      if (!even) continue;
      missing.set(kind, missing.get(kind) - 1);
      const [px, py] = view.camera.toScreen(...map.placeOf(node));
      found.push({
        x: px + box.left,
        y: py + box.top,
        kind,
        node,
        label: map.label[node],
        yy: result.loaded ? result.values("yy")[node] : null,
      });
    }
    return found;
  }, kinds);
