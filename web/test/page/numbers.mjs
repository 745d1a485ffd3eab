// Figures, numbers and what is saved of a packing; themes and narrow screens.
import assert from "node:assert/strict";
import { difference, painted, saved } from "../browser.mjs";
import { settle, tipOf, zoom } from "../run.mjs";
import { click, grain, light } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("a click on a curve shows the state next to it, which every curve of the stage marks", async (page) => {
  const shown = () => page.evaluate(() => window.arenite.state.get("snapshot")),
    last = await shown();
  for (const figure of ["wall-forces", "energies", "stress-path"]) {
    const drawing = page.locator(`[data-figure="${figure}"] .drawing`),
      mark = () =>
        drawing
          .locator('[aria-label="rule"][stroke="#a4522a"] line, [aria-label="dot"][fill="#a4522a"] circle')
          .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().x));
    await drawing.scrollIntoViewIfNeeded();
    await settle(page);
    const before = await mark(),
      box = await drawing.boundingBox();
    assert.ok(before.length > 0, `${figure} marks no state`);
    await page.mouse.click(box.x + 56, box.y + box.height / 2);
    await settle(page);
    assert.equal(await shown(), 0, figure);
    assert.ok((await mark())[0] < before[0] - 50, `${figure}: ${before} -> ${await mark()}`);
    await page.evaluate((k) => window.arenite.state.set({ snapshot: k }), last);
    await page.mouse.move(2, 2);
    await settle(page);
  }
  await page.evaluate(() => window.scrollTo(0, 0));
});

test("hovering a chart rings a point and shows its numbers with units, and a saved figure is without", async (page) => {
  const force = await tipOf(page, "wall-forces");
  assert.match(force[0], /^(bottom|top|left|right) wall$/);
  assert.match(force[1], /^time [\d.]+\u202fs$/);
  assert.match(force[2], /^force \u2212?[\d.]+\u202fk?N$/);
  const { shown, wanted } = await page.evaluate(() => {
    const svg = document.querySelector('[data-figure="wall-forces"] .drawing > svg'),
      ring = svg.querySelector(".passing circle");
    return {
      shown: [ring.getAttribute("cx"), ring.getAttribute("cy")].map(Number),
      wanted: [svg.scale("x").apply(svg.value.x), svg.scale("y").apply(svg.value.y)],
    };
  });
  shown.forEach((v, k) => assert.ok(Math.abs(v - wanted[k]) < 0.01, `${shown} is not ${wanted}`));
  assert.match((await tipOf(page, "sigma-norm"))[1], /^\u03c3norm [\d.]+$/);
  assert.match((await tipOf(page, "sigma-norm")).at(-1), /^P\(\u03c3norm\) [\d.]+/);
  assert.match((await tipOf(page, "coordination")).at(-1), /^z [\d.]+ \u00b1 [\d.]+$/);
  const source = await page.evaluate(
    () =>
      new Promise((done) => {
        const make = URL.createObjectURL;
        URL.createObjectURL = (blob) => {
          URL.createObjectURL = make;
          blob.text().then(done);
          return make.call(URL, blob);
        };
        document.querySelector('[data-figure="coordination"] [data-save="svg"]').click();
      }),
  );
  assert.equal(await page.locator('[data-figure="coordination"] [aria-label="tip"] text').count(), 1);
  assert.doesNotMatch(source, /passing|aria-label="tip"/);
  await page.mouse.move(2, 2);
  await settle(page);
  assert.equal(await page.locator('[aria-label="tip"] text').count(), 0);
  await page.evaluate(() => window.scrollTo(0, 0));
});

test("tips stay over their card", async (page) => {
  for (const figure of await page.locator("[data-figure]").evaluateAll((all) => all.map((f) => f.dataset.figure))) {
    if ((await tipOf(page, figure)).length === 0) continue;
    const over = await page.evaluate((name) => {
      const card = document.querySelector(`[data-figure="${name}"]`),
        a = card.querySelector('[aria-label="tip"] path').getBoundingClientRect(),
        b = card.getBoundingClientRect();
      return Math.max(b.left - a.left, a.right - b.right);
    }, figure);
    assert.ok(over < 1, `the tip of ${figure} is ${over} px beside its card`);
  }
  await page.mouse.move(2, 2);
  await page.evaluate(() => window.scrollTo(0, 0));
});

test("the slider moves the grains and the numbers with it", async (page) => {
  const slider = page.locator(".timeline input");
  const state = async () => ({
    place: await grain(page, 5),
    words: await page.locator(".timeline output").innerText(),
    tiles: await page.locator(".headlines").innerText(),
  });
  const last = await state();
  await slider.focus();
  await page.keyboard.press("Home");
  await settle(page);
  const first = await state();
  assert.notEqual(first.words, last.words);
  assert.notEqual(first.tiles, last.tiles);
  assert.ok(Math.hypot(first.place.x - last.place.x, first.place.y - last.place.y) > 1, "no grain moved");
  await page.keyboard.press("End");
  await settle(page);
});

test("a number that the page does not know stands at the end of its card with unit and sentence", async (page) => {
  await page.evaluate(() => {
    const { sample, state } = window.arenite,
      last = sample.snapshotCount - 1;
    sample.about.snapshots[last].texture.branch_length_m = { value: 0.01234, error: 0.00056 };
    sample.about.meanings.branch_length_m = ["m", "Mean distance of touching grains"];
    state.set({ snapshot: 0 });
    state.set({ snapshot: last });
  });
  const more = page.locator(".numbers details.remainder");
  await more.locator("summary").click();
  const row = more.locator('tr[title="Mean distance of touching grains"]');
  assert.match(await row.innerText(), /^branch length\s+12\.34 \u00b1 0\.56\u202fmm$/);
  await more.locator("summary").click();
});

test("every number that is declared of a state is in a row", async (page) => {
  const lost = await page.evaluate(() => {
    const { sample, state } = window.arenite,
      cells = document.querySelectorAll(".numbers td, .numbers th").length;
    const known = Object.keys(sample.about.meanings).filter(
      (name) =>
        name.split(".").reduce((tree, step) => tree?.[step], sample.texture(state.get("snapshot"))) !== undefined,
    );
    return { known: known.length, cells };
  });
  assert.ok(lost.known > 100 && lost.cells > lost.known, `${lost.cells} cells for ${lost.known} numbers`);
});

test("the dark theme darkens page and packing", async (page) => {
  assert.ok(difference(await (await painted(page))(2, 400), light.page) <= 2);
  await page.click("button.theme");
  await settle(page);
  const picture = await painted(page);
  assert.ok(Math.max(...(await picture(2, 400))) < 40);
  const box = await page.locator("canvas.grains").boundingBox();
  assert.ok(Math.max(...(await picture(box.x + 3, box.y + 3))) < 50);
  await page.click("button.theme");
  await settle(page);
});

test("every figure is drawn and saved as a whole SVG", async (page) => {
  const names = await page.locator("[data-figure]").evaluateAll((all) => all.map((f) => f.dataset.figure));
  for (const wanted of [
    "fabric",
    "sigma-norm",
    "forces",
    "coordination",
    "rev",
    "threshold",
    "wall-forces",
    "energies",
    "grain-scatter",
    "size-curve",
    "coarse-fields",
    "test-curves",
  ])
    assert.ok(names.includes(wanted), `${wanted} is missing from ${names}`);
  for (const name of names) {
    const source = (await saved(page, `[data-figure="${name}"] [data-save="svg"]`)).toString("utf8");
    const { fault, shapes, lost } = await page.evaluate((text) => {
      const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
      return {
        fault: parsed.querySelector("parsererror")?.textContent ?? null,
        shapes: parsed.querySelectorAll("path, rect, circle, line").length,
        lost: /NaN|undefined|var\(--/.exec(text)?.[0] ?? null,
      };
    }, source);
    assert.equal(fault, null, name);
    assert.ok(shapes > 5, `${name} holds ${shapes} shapes`);
    assert.equal(lost, null, `${name} holds ${lost}`);
  }
});

test("grains are set against each other by the numbers, and in the units, that the program says", async (page) => {
  const { scatter, across, up, options } = await page.evaluate(() => {
    const { sample, state } = window.arenite,
      options = [...document.querySelectorAll('[data-pick="up"] option')].map(({ value }) => value);
    const { scatter } = sample.ofRun("grain-scatter")[0];
    return { scatter, across: state.get("across"), up: state.get("up"), options };
  });
  assert.deepEqual([across, up], [scatter.across, scatter.up]);
  const quantities = scatter.axes.map(({ quantity }) => quantity);
  assert.ok(options.length > 5 && options.every((one) => quantities.includes(one)), `${options}`);
  const figure = page.locator('[data-figure="grain-scatter"]');
  await figure.scrollIntoViewIfNeeded();
  await page.selectOption('[data-pick="up"]', "pressure");
  await settle(page);
  const { label, unit } = scatter.axes.find(({ quantity }) => quantity === "pressure");
  const words = await figure.locator('[aria-label="y-axis label"]').first().textContent();
  assert.ok(words.includes(label) && words.includes(unit), `${words} has no ${unit}`);
  await page.selectOption('[data-pick="up"]', up);
});

test("the packing is saved as SVG with every grain and as PNG at twice the size", async (page) => {
  const save = (label) => saved(page, `.packing .save:has-text("${label}")`);
  const count = await page.evaluate(() => {
    window.scrollTo(0, 0);
    return window.arenite.sample.count;
  });
  await settle(page);
  const svg = (await save("SVG")).toString("utf8");
  assert.ok(svg.match(/<circle/g).length >= count);
  assert.ok(svg.match(/<line/g).length > count / 2);
  const png = await save("PNG");
  const width = await page.evaluate(() => window.arenite.view.camera.width);
  assert.equal(png.readUInt32BE(16), Math.round(2 * width));
});

test("on a narrow screen everything stands in one column and nothing is cut off", async (page) => {
  await page.setViewportSize({ width: 420, height: 900 });
  await settle(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 420, `the page is ${wide} px wide`);
});

test("on a touch screen one finger scrolls the page and two zoom and move the picture", async (page) => {
  const screen = await page.context().newCDPSession(page);
  await screen.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 5 });
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await page.waitForTimeout(200);
  const touch = (type, ...points) =>
    screen.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const before = await grain(page, 20),
    { x, y } = before;
  await touch("touchStart", [x, y]);
  for (let up = 5; up <= 125; up += 10) {
    await touch("touchMove", [x, y - up]);
    await settle(page);
  }
  await touch("touchEnd");
  await page.waitForFunction(() => window.scrollY > 60);
  assert.equal((await grain(page, 20)).radius, before.radius);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.waitForFunction(() => window.scrollY === 0);
  await touch("touchStart", [x - 20, y], [x + 20, y]);
  await touch("touchMove", [x - 30, y], [x + 30, y]);
  await touch("touchMove", [x - 40, y], [x + 40, y]);
  await touch("touchEnd");
  await settle(page);
  const after = await grain(page, 20);
  assert.ok(Math.abs(after.radius / before.radius - 2) < 1e-6, `${before.radius} -> ${after.radius}`);
  assert.ok(Math.hypot(after.x - x, after.y - y) < 1);
});
