// Headlines, figures and curves of the page of a small triaxial test of spheres.
import assert from "node:assert/strict";
import { pause } from "../browser.mjs";
import { settle } from "../run.mjs";
import { asItBegins, get, pictureWith, set } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("it has a tab a stage, its size, headlines, and its provenance at the end", async (page) => {
  assert.equal(await page.locator("h1").innerText(), "small sample of spheres");
  assert.match(await page.locator("header p").innerText(), /^150 spheres\s+·\s+glass\s+·\s+.*mm$/);
  assert.deepEqual(await page.locator('[role="tab"]').allInnerTexts(), ["Packing", "Confine", "Axial"]);
  const tiles = await page.locator(".tile:visible").allInnerTexts();
  assert.equal(tiles.length, 6);
  assert.match(tiles[0], /^peak q\/p[^]*0\.[5-9]/); // what was tested comes first
  assert.match(tiles[2], /^solid fraction[^]*0\.[56]/);
  assert.equal(await page.locator("footer tr").count(), 3);
});

test("figures show contacts, forces, stresses and the way to equilibrium", async (page) => {
  for (const id of ["contact-numbers", "forces", "sigma-norm", "wall-forces", "equilibrium"])
    assert.ok((await page.locator(`[data-figure="${id}"]:visible .drawing svg`).count()) > 0, id);
  assert.match(await page.locator('[data-figure="wall-forces"]:visible').innerText(), /front wall/);
  const halves = page.locator('[data-figure="orientations"]:visible .drawing g[data-set]');
  assert.equal(await halves.count(), 3);
  for (const half of await halves.all()) assert.equal(await half.locator("path[d^=M]:has(title)").count(), 75);
});

test("the test is drawn: the stress ratio and the volume against the axial strain", async (page) => {
  const curves = page.locator('[data-figure="test-curves"]:visible');
  assert.match(await curves.innerText(), /axial strain/);
  assert.match(await curves.innerText(), /volumetric strain/);
  assert.match(await curves.innerText(), /peak/);
});

test("the state shown is marked on the curves of its stage, and a click shows the one next to it", async (page) => {
  await pictureWith(page, { ...asItBegins, snapshot: 0 });
  const curves = page.locator('[data-figure="test-curves"]:visible .drawing svg').first();
  const marks = () =>
    curves.locator("line").evaluateAll((all) => all.map((line) => line.getAttribute("x1")).join(" "));
  const before = await marks();
  await curves.scrollIntoViewIfNeeded();
  const box = await curves.boundingBox();
  await page.mouse.click(box.x + 0.47 * box.width, box.y + 0.5 * box.height);
  await settle(page);
  assert.equal(await get(page, "snapshot"), 1);
  assert.notDeepEqual(await marks(), before);
});

test("contact orientations as the picture turn with it", async (page) => {
  await pictureWith(page, asItBegins);
  const figure = page.locator('[data-figure="orientations"]:visible');
  await figure.locator('[data-value="turned"]').click();
  await settle(page);
  const sectors = figure.locator("g[data-set=all] path:has(title)"),
    shapes = () => sectors.evaluateAll((all) => all.map((one) => one.getAttribute("d")));
  const before = await shapes();
  assert.ok(before.length >= 75 && before.length < 150, `${before.length} sectors are seen`);
  await set(page, { azimuth: 125 });
  await page.waitForTimeout(pause);
  const turned = await shapes();
  assert.notDeepEqual(turned, before);
  await set(page, { azimuth: 35, elevation: 90 });
  await page.waitForTimeout(pause);
  assert.equal((await shapes()).length, 75, "from above the upper half");
  await figure.locator('[data-value="above"]').click();
});
