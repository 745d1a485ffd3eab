// Title and slices of a sample in space.
import assert from "node:assert/strict";
import { difference, painted } from "../browser.mjs";
import { settle } from "../run.mjs";
import { kind, set, get, boxOf } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

/** What lies under the share (x, y) of a slice: its cell, phase and the quantities as the page writes them. */
const under = (page, axis, x, y) =>
  page.evaluate(
    ([axis, x, y]) => {
      const { slices, result } = window.arenite.volume,
        slice = slices.find(({ canvas }) => canvas.dataset.slice === axis),
        { left, top, width, height } = slice.canvas.getBoundingClientRect(),
        cell = slice.cellAt({ clientX: left + x * width, clientY: top + y * height }),
        voxel = result.voxelAt(cell);
      return { cell, voxel, phase: result.phase[voxel], value: result.written("xz", voxel) };
    },
    [axis, x, y],
  );

/** Places in a slice, as shares of its sides, each within a voxel of a phase and off the lines. */
async function placesIn(page, axis, phase) {
  const found = [];
  for (let row = 1; row < 12; row += 2)
    for (let column = 1; column < 12; column += 2) {
      const [x, y] = [(column + 0.25) / 12, (row + 0.25) / 12];
      if ((await under(page, axis, x, y)).phase === phase) found.push([x, y]);
    }
  return found;
}

test("it has a title, its size, headlines, and its provenance at the end", async (page) => {
  assert.match(await page.locator("h1").innerText(), /^shear of /);
  const size = await page.locator("header p").innerText();
  assert.match(size, /^12 × 12 × 12 voxels · 0\.120 × 0\.120 × 0\.120\u202fmm/);
  assert.ok((await page.locator(".tile").count()) >= 4);
  assert.match(await page.locator("footer").innerText(), /equilibrium to a relative residual/);
});

test("under shear it opens with the shear stress, in the picture and in the figure", async (page) => {
  assert.equal(await get(page, "component"), "xz");
  assert.match(await page.locator("svg.volume-key").textContent(), /^σxz, [kM]?Pa/);
  const figure = page.locator('[data-figure="stress-pdf"]');
  assert.match(await figure.locator(".drawing").textContent(), /σxz/);
  assert.ok((await page.locator('[data-figure="convergence"] .drawing svg').count()) > 0);
});

test("a slice carries the colours of the phases of its voxels", async (page) => {
  await set(page, { show: "phases", x: 4, y: 4, z: 4 });
  for (const axis of ["x", "y", "z"]) {
    await page.locator(`[data-slice="${axis}"]`).scrollIntoViewIfNeeded();
    await settle(page);
    const picture = await painted(page),
      box = await boxOf(page, `[data-slice="${axis}"]`);
    let seen = 0;
    for (const phase of [0, 1, 2])
      for (const [x, y] of await placesIn(page, axis, phase)) {
        const colour = await picture(box.x + x * box.width, box.y + y * box.height);
        assert.ok(difference(colour, kind[phase]) <= 3, `${axis}, phase ${phase}: ${colour}`);
        ++seen;
      }
    assert.equal(seen, 36);
  }
});

test("the slider of a slice leads it through the sample", async (page) => {
  const pixels = () => page.locator('[data-slice="z"]').evaluate((canvas) => canvas.toDataURL());
  const before = await pixels();
  await page.locator('[data-slider="z"]').focus();
  await page.keyboard.press("Home");
  await settle(page);
  assert.equal(await get(page, "z"), 0);
  assert.notEqual(await pixels(), before);
  assert.match(await page.locator('.slice:has([data-slider="z"]) output').innerText(), /^z = 5\.00\u202fµm$/);
});

test("the pointer on a slice is told phase, place and stress", async (page) => {
  await set(page, { show: "field", z: 6 });
  await page.locator('[data-slice="z"]').scrollIntoViewIfNeeded();
  const box = await boxOf(page, '[data-slice="z"]');
  for (const [phase, name] of [
    [0, "Void"],
    [1, "Matrix"],
    [2, "Grain"],
  ]) {
    const [x, y] = (await placesIn(page, "z", phase))[0],
      { cell, value } = await under(page, "z", x, y);
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    const words = await page.locator(".slices .tooltip").innerText();
    assert.ok(words.includes(name), words);
    for (const c of cell) assert.ok(words.includes(String(10 * c + 5)), `${words} has no ${10 * c + 5} µm`);
    assert.equal(words.includes(value), phase > 0, `${words}: ${value}`);
  }
});

test("a click in a slice leads the other two there", async (page) => {
  await page.locator('[data-slice="y"]').scrollIntoViewIfNeeded();
  const box = await boxOf(page, '[data-slice="y"]');
  await page.mouse.click(box.x + (2.5 / 12) * box.width, box.y + (3.5 / 12) * box.height);
  assert.deepEqual([await get(page, "x"), await get(page, "z")], [2, 8]);
});
