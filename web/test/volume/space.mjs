// The picture of a sample in space: turned, cut, saved, on a phone.
import assert from "node:assert/strict";
import { difference, elsewhere, painted, pause, saved } from "../browser.mjs";
import { becomes, rgb } from "../run.mjs";
import { kind, set, get, boxOf } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });


/** Places of the picture in space around which three pixels show the same voxel, with its phase; 0 where none is. */
const inSpace = (page) =>
  page.evaluate(() => {
    const { view, result } = window.arenite.volume,
      { width, height } = view.camera,
      found = [];
    for (let x = 0.2; x < 0.8; x += 0.0413)
      for (let y = 0.2; y < 0.8; y += 0.0413) {
        const at = (dx, dy) => view.cellAt([x * width + dx, y * height + dy]),
          cell = at(0, 0);
        if ([at(3, 0), at(-3, 0), at(0, 3), at(0, -3)].some((other) => String(other) !== String(cell))) continue;
        found.push({ x: x * width, y: y * height, cell, phase: cell ? result.phase[result.voxelAt(cell)] : 0 });
      }
    return found;
  });

/** One finger that goes from the middle of the picture by (dx, dy). */
async function swipe(page, dx, dy) {
  const cdp = await page.context().newCDPSession(page),
    box = await boxOf(page, "canvas.volume"),
    [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const send = (type, touchPoints) => cdp.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", [{ x, y }]);
  for (const share of [0.25, 0.5, 0.75, 1]) await send("touchMove", [{ x: x + share * dx, y: y + share * dy }]);
  await send("touchEnd", []);
  await page.waitForTimeout(pause);
}

test("the picture shows the phase that its line of sight meets, and what is cut away no more", async (page) => {
  await set(page, { show: "phases", cutx: 12, cuty: 12, cutz: 12, azimuth: 20, elevation: 15 });
  const lines = (visibility) =>
    page.evaluate((value) => {
      window.arenite.volume.view.over.style.visibility = value;
    }, visibility);
  await lines("hidden");
  await page.locator("canvas.volume").scrollIntoViewIfNeeded();
  const seen = [0, 0, 0];
  for (const cutx of [12, 4]) {
    await set(page, { cutx });
    await page.waitForTimeout(pause);
    const picture = await painted(page),
      box = await boxOf(page, "canvas.volume");
    for (const { x, y, cell, phase } of await inSpace(page)) {
      const [r, g, b] = await picture(box.x + x, box.y + y);
      ++seen[phase];
      // Shading darkens a colour and keeps its hue: the matrix is yellow, grains are blue.
      if (phase === 0) assert.ok(difference([r, g, b], kind[0]) <= 2, `void is ${[r, g, b]}`);
      else assert.ok(phase === 1 ? r > b + 20 : b > r + 20, `phase ${phase} is ${[r, g, b]}`);
      if (cell) assert.ok(cell[0] < cutx, `${cell} is cut away`);
    }
  }
  assert.ok(Math.min(...seen) > 5, `${seen}`);
  await lines("");
  await set(page, { cutx: 12 });
});

test("a phase that is switched off is looked through", async (page) => {
  await page.click('[data-toggle="matrix"]');
  const seen = await page.evaluate(() => {
    const { view, result } = window.arenite.volume,
      { width, height } = view.camera,
      found = new Set();
    for (let x = 0.1; x < 0.9; x += 0.01)
      for (let y = 0.1; y < 0.9; y += 0.01) {
        const cell = view.cellAt([x * width, y * height]);
        if (cell) found.add(result.phase[result.voxelAt(cell)]);
      }
    return [...found];
  });
  assert.deepEqual(seen, [2]);
  await page.click('[data-toggle="matrix"]');
});

test("what is below a level is looked through, and a surface is smooth where that is asked for", async (page) => {
  await set(page, { show: "field", surface: false });
  const shown = () =>
    page.evaluate(() => {
      const { view, result, state } = window.arenite.volume,
        { width, height } = view.camera,
        codes = result.codes(state.get("component")),
        found = [];
      for (let x = 0.1; x < 0.9; x += 0.01)
        for (let y = 0.1; y < 0.9; y += 0.01) {
          const cell = view.cellAt([x * width, y * height]);
          if (cell) found.push(codes[result.voxelAt(cell)]);
        }
      return { count: found.length, least: Math.min(...found) };
    });
  const pixels = async () => {
    await page.waitForTimeout(pause);
    return page.locator("canvas.volume").evaluate((canvas) => canvas.toDataURL());
  };
  const all = await shown();
  await set(page, { level: 10 });
  const above = await shown();
  assert.ok(all.least < 128 && above.least >= 128, `${all.least} ${above.least}`);
  assert.ok(above.count < all.count && above.count > 0);
  assert.match(await page.locator('.level output').innerText(), /Pa$/);
  const faces = await pixels();
  await page.click('[data-toggle="surface"]');
  assert.notEqual(await pixels(), faces);
  await set(page, { component: "zz" });
  assert.equal(await get(page, "level"), 0);
  await set(page, { component: "xz", surface: false });
});

test("it turns by dragging and keys, zooms with Ctrl and the wheel; 0 shows it as in the beginning", async (page) => {
  const seen = () => Promise.all(["azimuth", "elevation", "zoom"].map((key) => get(page, key)));
  await page.keyboard.press("0");
  await page.locator("canvas.volume").scrollIntoViewIfNeeded();
  const box = await boxOf(page, "canvas.volume"),
    middle = [box.x + box.width / 2, box.y + box.height / 2];
  await set(page, { azimuth: 35, elevation: 25 });
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 50, middle[1] + 25, { steps: 4 });
  await page.mouse.up();
  await becomes(seen, [15, 35, 1]);
  await page.locator("canvas.volume").focus();
  await page.keyboard.press("ArrowLeft");
  await becomes(seen, [20, 35, 1]);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -100);
  await page.keyboard.up("Control");
  await becomes(seen, [20, 35, 1.41]);
  await page.keyboard.press("0");
  await becomes(seen, [35, 25, 1]);
});

test("picture and slices can be saved", async (page) => {
  for (const of of ['[aria-label="Sample"]', '[aria-label="Slices"]']) {
    assert.equal((await saved(page, `${of} [data-save="png"]`)).subarray(1, 4).toString(), "PNG");
    const svg = (await saved(page, `${of} [data-save="svg"]`)).toString();
    assert.match(svg, /^<svg[^]*data:image\/png[^]*<\/svg>$/);
  }
});

test("the address brings the view back", async (page) => {
  await set(page, { show: "field", component: "mises", x: 3, z: 9, cuty: 7, azimuth: 120.5, elevation: -10, zoom: 2 });
  const again = await page.context().newPage();
  await again.goto(page.url());
  await again.waitForSelector("html[data-ready]");
  for (const [key, value] of Object.entries({ component: "mises", x: 3, z: 9, cuty: 7, azimuth: 120.5, zoom: 2 }))
    assert.equal(await get(again, key), value, key);
  assert.deepEqual(await again.evaluate(() => ({ ...window.arenite.volume.view.look })), {
    azimuth: 120.5,
    elevation: -10,
    zoom: 2,
  });
  await again.close();
});

test("it opens dark, on a phone of 390 pixels, where a finger turns it and scrolls the page", async (page) => {
  const phone = { viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true, isMobile: true };
  await elsewhere(page, phone, null, async (other) => {
    assert.equal(await other.evaluate(() => document.documentElement.scrollWidth), 390);
    const { x, y, width } = await boxOf(other, "canvas.volume");
    assert.ok(width > 300);
    assert.ok(difference(await (await painted(other))(x + 3, y + 3), rgb("#161a1f")) <= 2);
    await swipe(other, 80, 0);
    assert.ok((await get(other, "azimuth")) < 35, "a finger to the side turns it");
    const before = await get(other, "azimuth");
    await swipe(other, 0, -200);
    assert.deepEqual([await get(other, "azimuth"), await get(other, "elevation")], [before, 25]);
    assert.ok(await other.evaluate(() => scrollY > 0), "a finger upwards scrolls the page");
  });
});

test("without WebGL2 a sentence stands in the picture's place, and the slices remain", async (page) => {
  const without = () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (name, options) {
      return name === "webgl2" ? null : getContext.call(this, name, options);
    };
  };
  await elsewhere(page, { viewport: { width: 1400, height: 900 } }, without, async (other) => {
    assert.match(await other.locator(".stage .nothing").innerText(), /no WebGL2.*slices/);
    assert.match(await other.locator("svg.volume-key").textContent(), /^σxz/);
    assert.equal(await other.locator("[data-slice]").count(), 3);
  });
});
