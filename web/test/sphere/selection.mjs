// A sphere that is chosen in the picture, the table or a chart is marked in all of them.
import assert from "node:assert/strict";
import { settle } from "../run.mjs";
import { asItBegins, canvasOf, get, pictureWith, placesIn, set } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

const marks = (page) =>
  page.evaluate(() => window.arenite.spheres.view.over.querySelectorAll("circle.selected").length);

test("a click on a sphere marks it in the table and the charts, and a second one takes that away", async (page) => {
  await pictureWith(page, asItBegins);
  const { x, y, sphere } = (await placesIn(page)).find((place) => place.sphere !== null);
  await canvasOf(page).scrollIntoViewIfNeeded();
  const box = await canvasOf(page).boundingBox();
  await page.mouse.click(box.x + x, box.y + y);
  assert.equal(await get(page, "selected"), sphere);
  assert.equal(await marks(page), 1);
  const row = page.locator('.grains-rows:visible tr[aria-selected="true"]');
  assert.equal(Number(await row.getAttribute("data-grain")), sphere);
  const id = await page.evaluate((g) => window.arenite.spheres.result.state.id[g], sphere);
  assert.equal(await row.locator("td").first().innerText(), String(id));
  for (const figure of ["grain-scatter", "sigma-norm"]) {
    const drawn = page.locator(`[data-figure="${figure}"]:visible`);
    await drawn.scrollIntoViewIfNeeded();
    await settle(page);
    assert.ok((await drawn.locator(".selected").count()) > 0, figure);
  }
  await canvasOf(page).scrollIntoViewIfNeeded();
  const now = await canvasOf(page).boundingBox();
  await page.mouse.click(now.x + x, now.y + y);
  assert.equal(await get(page, "selected"), null);
  assert.equal(await marks(page), 0);
});

test("the table has every sphere, sorted by a click on a head, and a row chooses its sphere", async (page) => {
  const rows = page.locator(".grains-rows:visible tr[data-grain]");
  await page.locator(".grain-table:visible").scrollIntoViewIfNeeded();
  assert.match(await page.locator(".grain-table:visible .caption").innerText(), /^150 spheres in the state shown/);
  await page.click('.grains-rows:visible th button[title="Pressure of grains"]');
  const first = Number(await rows.first().getAttribute("data-grain")),
    pressure = await page.evaluate(() => [...window.arenite.spheres.result.state.pressure]);
  assert.equal(pressure[first], Math.max(...pressure));
  await rows.first().click();
  assert.equal(await get(page, "selected"), first);
  assert.equal(await marks(page), 1);
  await page.locator(".grains-rows:visible").focus();
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await get(page, "selected"), first);
  await set(page, { selected: null });
});

test("the stress of a sphere over its mean is what the figure of it shows", async (page) => {
  const { mean, most } = await page.evaluate(() => {
    const { pressure, stress } = window.arenite.spheres.result.last,
      ratio = pressure.map((p, g) => p / stress[g]).filter(Number.isFinite);
    return { mean: ratio[0], most: Math.max(...ratio.map((r) => Math.abs(r / ratio[0] - 1))) };
  });
  assert.ok(mean > 0 && most < 0.02, `${mean} ${most}`);
});
