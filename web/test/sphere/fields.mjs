// Slices through the coarse-grained fields of the states of a small triaxial test of spheres.
import assert from "node:assert/strict";
import { difference, elsewhere, painted, saved } from "../browser.mjs";
import { settle } from "../run.mjs";
import { asItBegins, get, set } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

const card = '[aria-label="Coarse-grained fields"]:visible';
const slice = (axis) => `${card} [data-slice="${axis}"]`;
const stressed = { ...asItBegins, field: "pressure" };

/** The colours of every eleventh cell of a slice, as they are and as the theme's map has the values there. */
const coloursOf = (page, axis, map) =>
  page.evaluate(
    ([axis, name]) => {
      const { slices, fields, state } = window.arenite.spheres,
        { canvas, u, v, axis: normal } = slices.find(({ canvas }) => canvas.dataset.slice === axis),
        { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height),
        { values, scale } = fields.layer(state.get("field")),
        numbers = (colour) =>
          colour[0] === "#"
            ? [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16))
            : colour.match(/\d+/g).map(Number),
        found = [];
      for (let k = 0; k < canvas.width * canvas.height; k += 11) {
        const cell = [];
        cell[normal] = state.get(axis);
        cell[u] = k % canvas.width;
        cell[v] = canvas.height - 1 - Math.floor(k / canvas.width);
        const value = values[cell[0] + fields.size[0] * (cell[1] + fields.size[1] * cell[2])],
          share = (value - scale.low) / (scale.high - scale.low);
        found.push({
          value,
          painted: [...data.slice(4 * k, 4 * k + 3)],
          expected: numbers(window.arenite.theme.maps[name](Math.min(1, Math.max(0, share)))),
        });
      }
      return found;
    },
    [axis, map],
  );

const picture = (page, axis) => page.locator(slice(axis)).evaluate((canvas) => canvas.toDataURL());

test("each slice has the colours of its cells' values, by the map of the field that is chosen", async (page) => {
  for (const [field, map] of [
    ["solid_fraction", "viridis"],
    ["pressure", "magma"],
    ["shear", "diverging"],
    ["vy", "diverging"],
  ]) {
    await set(page, { ...asItBegins, field });
    for (const axis of ["x", "y", "z"]) {
      const cells = await coloursOf(page, axis, map);
      assert.ok(cells.length > 5 && new Set(cells.map(({ value }) => value)).size > 3, `${field} ${axis}`);
      // The table has 254 steps, and a map of colours seldom goes by more than 3 of 255 in one.
      for (const { painted, expected } of cells)
        assert.ok(difference(painted, expected) <= 4, `${painted} ${expected}`);
    }
  }
});

test("the reader chooses a field by its name in the plane's words, and the bar tells unit and values", async (page) => {
  await set(page, stressed);
  const list = page.locator(`${card} select`);
  assert.deepEqual(await list.locator("option").allInnerTexts(), [
    "Solid fraction",
    "Density",
    "Velocity",
    ...["x", "y", "z"].map((axis) => `Velocity along ${axis}`),
    "Pressure",
    "Deviator of stress",
    ...["xy", "yz", "xz"].map((axes) => `Shear stress ${axes}`),
    "Kinetic pressure",
  ]);
  const key = page.locator(`${card} svg.slices-key`);
  for (const [field, title] of [
    ["Pressure", /^Pressure p, k?Pa/],
    ["Density", /^Density ρ, kg\/m³/],
    ["Solid fraction", /^Solid fraction φ[^,]*0\.[3-6]/],
  ]) {
    await list.selectOption({ label: field });
    await settle(page);
    assert.match(await key.textContent(), title);
    assert.ok((await key.locator("path").count()) > 0, "a histogram on the bar");
  }
  assert.equal(await get(page, "field"), "solid_fraction");
  assert.match(
    await page.locator(`${card} .caption`).innerText(),
    /kernel along an axis: \d\.\d+\smm; \d+ × \d+ × \d+ cells/,
  );
});

test("a slider moves a slice, and another state has other fields in its own container", async (page) => {
  await set(page, { ...stressed, z: 2 });
  const before = await picture(page, "z"),
    place = () =>
      page
        .locator(`${card} .slice`, { has: page.locator('[data-slice="y"]') })
        .locator("output")
        .innerText();
  await page.locator(`${card} [data-slider="z"]`).focus();
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.equal(await get(page, "z"), 3);
  const moved = await picture(page, "z"),
    [late, volumes] = [await place(), []];
  assert.notEqual(moved, before);
  await set(page, { snapshot: 0 });
  await settle(page);
  assert.notEqual(await picture(page, "z"), moved);
  assert.notEqual(await place(), late, "the top came down");
  for (const snapshot of [0, 1]) {
    await set(page, { snapshot });
    volumes.push(await page.evaluate(() => window.arenite.spheres.fields.sides.reduce((a, b) => a * b)));
  }
  assert.ok(volumes[0] !== volumes[1]);
});

test("the pointer is told the fields of a cell, and a click leads the other two slices there", async (page) => {
  await set(page, { ...stressed, x: 0, y: 0, z: 4 });
  await page.locator(slice("z")).scrollIntoViewIfNeeded();
  const box = await page.locator(slice("z")).boundingBox(),
    [width, height] = await page.evaluate(() => window.arenite.spheres.fields.size);
  await page.mouse.click(box.x + (5.5 / width) * box.width, box.y + (1 - 3.5 / height) * box.height);
  assert.deepEqual([await get(page, "x"), await get(page, "y")], [5, 3]);
  const words = await page.locator(`${card} .tooltip:visible`).innerText(),
    pressure = await page.evaluate(() => {
      const { fields } = window.arenite.spheres;
      return fields.layer("pressure").values[fields.indexOf([5, 3, 4])];
    });
  const shown = words.match(/^Pressure (-|\u2212)?([\d.]+)\s(k?)Pa/);
  assert.ok(shown, words);
  assert.ok(Math.abs(Number(shown[2]) * (shown[3] ? 1e3 : 1) - Math.abs(pressure)) < 0.006 * Math.abs(pressure), words);
  for (const part of ["x, y, z", "φ", "ρ", "vx", "σxy", "pkin"]) assert.ok(words.includes(part), `${words}: ${part}`);
  await page.mouse.move(2, 2);
});

test("the table has every cell, whose density is that of the spheres smeared by the kernel", async (page) => {
  await set(page, stressed);
  const [first, ...lines] = (await saved(page, `${card} [data-save="csv"]`)).toString().trim().split("\n"),
    head = first.match(/"[^"]*"|[^,]+/g).map((name) => name.replaceAll('"', "")),
    rows = lines.map((line) => line.split(",").map(Number)),
    column = (name) => head.findIndex((one) => one.startsWith(name));
  const { cells, width, balls, steps } = await page.evaluate(() => {
    const { fields, result } = window.arenite.spheres,
      { x, y, z, radius } = result.state,
      { width, levels } = window.arenite.spheres.fields.state.layers.density;
    return {
      cells: fields.state.size,
      width: fields.state.width,
      balls: [...radius].map((r, g) => [x[g], y[g], z[g], result.materials[0].density * (4 / 3) * Math.PI * r ** 3]),
      steps: width / levels,
    };
  });
  assert.equal(rows.length, cells);
  // Lucy's function in space, whose radius is sqrt(12) widths.
  const c = Math.sqrt(12) * width,
    smeared = (q) => (q < 1 ? (105 / (16 * Math.PI * c ** 3)) * (1 + 3 * q) * (1 - q) ** 3 : 0);
  const [at, density] = [["x,", "y,", "z,"].map(column), column("ρ")];
  for (let k = 0; k < rows.length; k += 17) {
    const expected = balls.reduce(
      (sum, [...ball]) => sum + ball[3] * smeared(Math.hypot(...at.map((c, axis) => rows[k][c] - ball[axis])) / c),
      0,
    );
    // Half a step of the codes, which are wider away from their middle; places and radii are rounded to 24 bits.
    assert.ok(Math.abs(rows[k][density] - expected) < steps + 1e-5 * expected, `${rows[k][density]} and ${expected}`);
  }
});

test("slices and bar can be saved, and the address brings field and slices back", async (page) => {
  await set(page, { ...stressed, field: "shear", y: 2 });
  assert.equal((await saved(page, `${card} [data-save="png"]`)).subarray(1, 4).toString(), "PNG");
  const svg = (await saved(page, `${card} [data-save="svg"]`)).toString();
  assert.equal(svg.match(/data:image\/png/g).length, 3);
  assert.match(svg, /Shear stress xy/);
  const again = await page.context().newPage();
  await again.goto(page.url());
  await again.waitForSelector("html[data-ready]");
  assert.deepEqual([await get(again, "field"), await get(again, "y")], ["shear", 2]);
  await again.close();
});

test("they are there dark, on a phone, and without WebGL2", async (page) => {
  const phone = { viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true, isMobile: true };
  const without = () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (name, options) {
      return name === "webgl2" ? null : getContext.call(this, name, options);
    };
  };
  await elsewhere(page, phone, without, async (other) => {
    await set(other, { field: "shear" });
    assert.equal(await other.evaluate(() => document.documentElement.scrollWidth), 390);
    for (const axis of ["x", "y", "z"]) {
      const cells = await coloursOf(other, axis, "diverging");
      for (const { painted, expected } of cells) assert.ok(difference(painted, expected) <= 4);
      await other.locator(slice(axis)).scrollIntoViewIfNeeded();
      const box = await other.locator(slice(axis)).boundingBox();
      assert.ok(box.width > 60 && box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
    }
    const box = await other.locator(slice("x")).boundingBox(),
      pixel = (await painted(other))(box.x + box.width / 4, box.y + box.height / 4);
    assert.ok(Math.min(...pixel) < 200, `dark in its middle: ${pixel}`);
  });
});
