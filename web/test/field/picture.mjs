// What the page of a cemented sample paints.
import assert from "node:assert/strict";
import { difference, painted } from "../browser.mjs";
import { rgb, settle } from "../run.mjs";
import { light, set, tab, places } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("a row of tabs leads to the sample, its load and its pull", async (page) => {
  assert.deepEqual(await page.locator(".tabs button").allInnerTexts(), ["Cement", "Tension", "Failure"]);
});

test("nodes carry their phase's colour", async (page) => {
  await tab(page, "Cement");
  await set(page, { outlines: false });
  await settle(page);
  const picture = await painted(page),
    some = await places(page, [0, 3, 4]);
  assert.ok(some.length >= 10, `${some.length} places`);
  for (const { x, y, kind } of some)
    assert.ok(difference(await picture(x, y), light.kind[kind]) <= 3, `kind ${kind}: ${await picture(x, y)}`);
  const box = await page.locator("canvas.nodes:visible").boundingBox();
  assert.ok(difference(await picture(box.x + 2, box.y + 2), light.card) <= 1);
});

test("a sample that was not loaded offers no field", async (page) => {
  assert.equal(await page.locator('section.sample:visible [data-choice="show"] [data-value="field"]').count(), 0);
});

test("voids have a colour each, by chance or by size, and grains step back", async (page) => {
  const colours = [];
  for (const cavities of ["any", "size"]) {
    await set(page, { show: "voids", cavities, outlines: false });
    await settle(page);
    const picture = await painted(page);
    for (const { x, y } of await places(page, [3, 4]))
      assert.ok(difference(await picture(x, y), rgb("#d3d7da")) <= 3, `grain: ${await picture(x, y)}`);
    const hole = await page.evaluate(() => {
      const {
          view,
          result: { map },
        } = window.arenite.field,
        box = view.canvas.getBoundingClientRect(),
        { label, nodes } = map.cavities.voids;
      const largest = 1 + nodes.indexOf(nodes.reduce((a, b) => Math.max(a, b))),
        inside = (k) => label[k] === largest;
      const node = label.findIndex(
        (l, k) => l === largest && [1, -1, map.width, -map.width].every((step) => inside(k + step)),
      );
      const [px, py] = view.camera.toScreen(...map.placeOf(node));
      return { x: px + box.left, y: py + box.top };
    });
    const [r, g, b] = await picture(hole.x, hole.y);
    assert.ok(Math.max(r, g, b) - Math.min(r, g, b) > 30 || Math.max(r, g, b) < 90, `void: ${[r, g, b]}`);
    colours.push([r, g, b].join(" "));
  }
  assert.notEqual(colours[0], colours[1]);
  await set(page, { show: "phases" });
});

test("stress is painted by the scale: low blue, high orange, void empty", async (page) => {
  await tab(page, "Tension");
  await set(page, { show: "field", component: "yy", around: "mean", outlines: false });
  await settle(page);
  const picture = await painted(page),
    mean = await page.evaluate(() => window.arenite.field.result.mean);
  let low = 0,
    high = 0;
  for (const { x, y, kind, yy } of await places(page, [0, 3, 4])) {
    const [r, , b] = await picture(x, y);
    if (kind === 0) assert.ok(difference(await picture(x, y), light.empty) <= 2, "void");
    else if (yy < 0.75 * mean) {
      ++low;
      assert.ok(b > r, `low stress is ${await picture(x, y)}`);
    } else if (yy > 1.25 * mean) {
      ++high;
      assert.ok(r > b, `high stress is ${await picture(x, y)}`);
    }
  }
  assert.ok(low + high > 0);
});

test("every component, centre, law and clip paints its own picture", async (page) => {
  const shot = async () => {
    await settle(page);
    const box = await page.locator("canvas.nodes:visible").boundingBox();
    return (await page.screenshot({ clip: box })).toString("base64");
  };
  const seen = new Map();
  for (const component of ["yy", "xx", "xy", "hydrostatic", "principal", "ux", "uy", "travel"]) {
    await set(page, { component });
    seen.set(component, await shot());
  }
  await set(page, { component: "yy" });
  for (const changes of [
    { around: "zero" },
    { around: "ends" },
    { law: "symlog" },
    { clip: "5" },
    { by: "grain" },
    { chains: true, threshold: 1.5 },
    { crosses: true },
    { outlines: true },
  ]) {
    const before = await page.evaluate(
      (keys) => Object.fromEntries(keys.map((k) => [k, window.arenite.field.state.get(k)])),
      Object.keys(changes),
    );
    await set(page, changes);
    seen.set(JSON.stringify(changes), await shot());
    await set(page, before);
  }
  assert.equal(
    new Set(seen.values()).size,
    seen.size,
    `${seen.size} states gave ${new Set(seen.values()).size} pictures`,
  );
});

test("values come to the page within a thousandth of their range", async (page) => {
  const { least, most, about } = await page.evaluate(() => {
    const { result } = window.arenite.field,
      values = result.values("yy");
    let [low, high] = [Infinity, -Infinity];
    values.forEach((v, k) => {
      if (result.map.kind[k] !== 0) [low, high] = [Math.min(low, v), Math.max(high, v)];
    });
    return { least: low, most: high, about: result.about.components.sigma_yy };
  });
  for (const [got, wanted] of [
    [least, about.least],
    [most, about.most],
  ])
    assert.ok(Math.abs(got - wanted) <= 1e-3 * (about.most - about.least), `${got} is not ${wanted}`);
});

test("what carries less than the threshold steps back", async (page) => {
  await set(page, { chains: true, threshold: 1 });
  await settle(page);
  const picture = await painted(page),
    mean = await page.evaluate(() => window.arenite.field.result.mean);
  for (const { x, y, kind, yy } of await places(page, [3, 4])) {
    const aside = difference(await picture(x, y), light.aside) <= 4;
    if (kind && Math.abs(yy / mean) < 0.6) assert.ok(aside, `weak: ${await picture(x, y)}`);
  }
  await set(page, { chains: false });
});

test("the colour bar says what lies beyond its ends", async (page) => {
  await set(page, { clip: "5" });
  await settle(page);
  assert.match(await page.locator(".field-key:visible").textContent(), /\u202f% \u25b8/);
  await set(page, { clip: "all" });
  await settle(page);
  assert.doesNotMatch(await page.locator(".field-key:visible").textContent(), /%/);
  await set(page, { clip: "0.1" });
});
