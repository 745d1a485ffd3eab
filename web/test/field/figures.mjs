// Pointer, cracks and figures of the page of a cemented sample; themes and narrow screens.
import assert from "node:assert/strict";
import { difference, painted, saved } from "../browser.mjs";
import { settle, tipOf, zoom } from "../run.mjs";
import { light, set, tab, places } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

/** Those on grains in one piece: at periodic sides a grain may lie at both edges. */
const whole = (page, list) =>
  page.evaluate(
    (all) =>
      all.filter(({ label }) => {
        const { result } = window.arenite.field,
          { left, right, bottom, top } = result.boxOfGrain(label - 1);
        return Math.max(right - left, top - bottom) < 3 * result.radiusOfGrain(label - 1);
      }),
    list,
  );

test("hovering tells a node's numbers, a click shows its grain close up, Escape shows all", async (page) => {
  const [large] = await whole(page, await places(page, [4]));
  await page.mouse.move(large.x, large.y);
  const words = await page.locator(".tooltip:visible").innerText();
  assert.match(words, /Large grain/);
  assert.match(words, /\u03c3yy[\s\S]*Pa/);
  const before = await page.evaluate(() => window.arenite.field.view.camera.scale);
  await page.mouse.click(large.x, large.y);
  await settle(page);
  assert.ok((await page.evaluate(() => window.arenite.field.view.camera.scale)) > 2 * before);
  assert.match(await page.locator(".close-up:visible").innerText(), /mean \u03c3/);
  await page.keyboard.press("Escape");
  await settle(page);
  assert.ok(Math.abs((await page.evaluate(() => window.arenite.field.view.camera.scale)) - before) < 1e-6 * before);
  assert.equal(await page.locator(".close-up:visible").count(), 0);
});

test("zoomed in, a node is a square of one colour", async (page) => {
  const node = await page.evaluate(() => {
    const { label, width, height } = window.arenite.field.result.map,
      middle = (width >> 1) + width * (height >> 1);
    return Array.from(label.keys())
      .slice(middle)
      .find((k) => label[k] > 0 && label[k] === label[k - 1] && label[k] === label[k + width]);
  });
  const { x, y } = await page.evaluate((k) => {
    const { view, result } = window.arenite.field,
      box = view.canvas.getBoundingClientRect(),
      [px, py] = view.camera.toScreen(...result.map.placeOf(k));
    return { x: Math.round(px + box.left), y: Math.round(py + box.top) };
  }, node);
  await page.mouse.move(x, y);
  await zoom(page, 11);
  const place = await page.evaluate((k) => {
    const { view, result } = window.arenite.field,
      box = view.canvas.getBoundingClientRect(),
      [px, py] = view.camera.toScreen(...result.map.placeOf(k));
    return { x: px + box.left, y: py + box.top, size: result.map.spacing * view.camera.scale };
  }, node);
  assert.ok(place.size > 30, `${place.size} px a node`);
  await page.mouse.move(2, 2);
  await settle(page);
  const picture = await painted(page),
    middle = await picture(place.x, place.y);
  for (const [i, j] of [
    [-0.4, -0.4],
    [0.4, -0.4],
    [0.4, 0.4],
  ])
    assert.deepEqual(await picture(place.x + i * place.size, place.y + j * place.size), middle);
  await page.evaluate(() => window.arenite.field.view.reset());
  await settle(page);
});

test("cracks appear in the order of the pull, by type, with the slider", async (page) => {
  await tab(page, "Failure");
  const slider = page.locator(".timeline:visible input");
  await slider.focus();
  await page.keyboard.press("Home");
  await settle(page);
  const first = await page.locator('[data-figure="stress-strain"]:visible .drawing').innerHTML();
  const none = await page.evaluate(() => window.arenite.field.view.broken);
  await page.keyboard.press("End");
  await settle(page);
  const all = await page.evaluate(() => window.arenite.field.view.broken);
  assert.ok(all > none, `${none} -> ${all}`);
  assert.notEqual(await page.locator('[data-figure="stress-strain"]:visible .drawing').innerHTML(), first);
  const crack = await page.evaluate(() => {
    const { view, result } = window.arenite.field,
      box = view.canvas.getBoundingClientRect();
    const [x, y] = view.camera.toScreen(result.cracks.x[0], result.cracks.y[0]);
    return { x: x + box.left, y: y + box.top, type: result.cracks.type[0] };
  });
  const picture = await painted(page);
  assert.ok(
    difference(await picture(crack.x, crack.y), light.crack[crack.type]) <= 30,
    `${await picture(crack.x, crack.y)}`,
  );
});

test("densities over the mean of the phase carry their fits", async (page) => {
  await tab(page, "Tension");
  const dashed = () => page.locator('[data-figure="stress-pdf"]:visible .drawing [stroke-dasharray="6 3"]').count();
  assert.equal(await dashed(), 0);
  await page.click('[data-figure="stress-pdf"] [data-choice="norm"]:visible [data-value="own"]');
  await settle(page);
  assert.ok((await dashed()) >= 2, `${await dashed()} tails`);
  await page.click('[data-figure="stress-pdf"] [data-choice="norm"]:visible [data-value="sample"]');
});

test("the pointer reads the curve of the test, and a click goes to the step that it shows", async (page) => {
  await tab(page, "Failure");
  const lines = await tipOf(page, "stress-strain"),
    step = Number(lines[0].match(/^step (\d+)$/)[1]);
  assert.match(lines[1], /^strain [\d.]+\u202f10\u207b\u00b3$/);
  assert.match(lines[2], /^stress \u2212?[\d.]+\u202f[kM]?Pa$/);
  await page.mouse.down();
  await page.mouse.up();
  await settle(page);
  assert.equal(await page.evaluate(() => window.arenite.field.state.get("step")), step - 1);
  await set(page, { step: (await page.evaluate(() => window.arenite.field.result.steps)) - 1 });
  await page.mouse.move(2, 2);
  await page.evaluate(() => window.scrollTo(0, 0));
});

test("the numbers are folded, and opened they are there with their units", async (page) => {
  await tab(page, "Tension");
  const numbers = page.locator(".numbers:visible");
  assert.equal(await numbers.locator("table").first().isVisible(), false);
  await numbers.locator("summary").click();
  assert.match(await numbers.innerText(), /apparent modulus E\s+[\d.]+\u202f[MG]Pa/);
  await numbers.locator("summary").click();
});

test("labels of an axis stand beside its ticks", async (page) => {
  await tab(page, "Failure");
  const over = await page.locator("[data-figure]:visible").evaluateAll((all) =>
    all.flatMap((figure) => {
      const label = figure.querySelector('[aria-label="y-axis label"]')?.getBoundingClientRect(),
        ticks = [...figure.querySelectorAll('[aria-label="y-axis tick label"] text')].map((t) =>
          t.getBoundingClientRect(),
        );
      return label
        ? ticks
            .filter((tick) => tick.left < label.right - 0.5 && tick.right > label.left)
            .map(() => figure.dataset.figure)
        : [];
    }),
  );
  assert.deepEqual(over, []);
});

test("every figure is drawn and saved as a whole SVG", async (page) => {
  for (const [title, wanted] of [
    ["Tension", ["stress-pdf", "cavities", "convergence"]],
    ["Failure", ["stress-strain", "broken-bonds", "energy-balance"]],
  ]) {
    await tab(page, title);
    const names = await page.locator("[data-figure]:visible").evaluateAll((all) => all.map((f) => f.dataset.figure));
    for (const name of wanted) assert.ok(names.includes(name), `${name} is missing from ${names}`);
    for (const name of names) {
      const source = (await saved(page, `[data-figure="${name}"] [data-save="svg"]:visible`)).toString("utf8");
      assert.ok(source.match(/<(path|rect|circle|line)/g).length > 5, `${name} is bare`);
      assert.doesNotMatch(source, /NaN|undefined|var\(--/, name);
    }
  }
});

test("the picture is saved as SVG with its nodes inside and as PNG at twice the size", async (page) => {
  await tab(page, "Tension");
  await page.evaluate(() => window.scrollTo(0, 0));
  const svg = (await saved(page, '.sample:visible .save:has-text("SVG")')).toString("utf8");
  assert.match(svg, /<image[^>]*href="data:image\/png;base64,[A-Za-z0-9+/=]{2000,}"/);
  assert.doesNotMatch(svg.replace(/base64,[^"]*/, ""), /NaN|undefined/);
  const png = await saved(page, '.sample:visible .save:has-text("PNG")');
  assert.equal(
    png.readUInt32BE(16),
    Math.round(2 * (await page.evaluate(() => window.arenite.field.view.camera.width))),
  );
});

test("the dark theme darkens page and field", async (page) => {
  await page.click("button.theme");
  await settle(page);
  const picture = await painted(page),
    [hole] = await places(page, [0]);
  assert.ok(Math.max(...(await picture(2, 400))) < 40);
  assert.ok(Math.max(...(await picture(hole.x, hole.y))) < 60, `void: ${await picture(hole.x, hole.y)}`);
  await page.click("button.theme");
});

test("on a narrow screen everything stands in one column and nothing is cut off", async (page) => {
  await page.setViewportSize({ width: 420, height: 900 });
  for (const title of ["Cement", "Tension", "Failure"]) {
    await tab(page, title);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 420, `${title} is ${wide} px wide`);
  }
});

test("the slider draws the sample as it was deformed: each node where it went, magnified as it says", async (page) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await tab(page, "Tension");
  await set(page, { show: "phases", outlines: false, crosses: false, deform: 1 });
  await settle(page);
  const said = await page.locator('section.sample:visible .threshold:has([data-slider="deform"]) output').innerText();
  const { times, nodes } = await page.evaluate(() => {
    const { view, result } = window.arenite.field,
      { map } = result,
      box = view.canvas.getBoundingClientRect(),
      [ux, uy] = [result.values("ux"), result.values("uy")],
      found = [];
    const inside = (k) =>
      [-2, -1, 0, 1, 2].every((j) => [-2, -1, 0, 1, 2].every((i) => map.kind[k + i + map.width * j] === map.kind[k]));
    for (let tries = 0; tries < 50000 && found.length < 12; ++tries) {
      const x = 4 + ((tries * 7919) % (map.width - 8)),
        y = Math.floor(map.height * 0.6) + ((tries * 104729) % Math.floor(map.height * 0.3)),
        k = x + map.width * y;
      if (map.kind[k] < 2 || !inside(k)) continue;
      const [wx, wy] = map.placeOf(k),
        [px, py] = view.camera.toScreen(wx + view.times * ux[k], wy + view.times * uy[k]),
        [qx, qy] = view.camera.toScreen(wx, wy);
      found.push({ x: px + box.left, y: py + box.top, moved: Math.hypot(px - qx, py - qy), kind: map.kind[k] });
    }
    return { times: view.times, nodes: found };
  });
  assert.match(said, /^\u00d7/);
  assert.ok(times > 1 && nodes.length > 5 && nodes.some(({ moved }) => moved > 10), `${times}, ${nodes.length} nodes`);
  const picture = await painted(page);
  for (const { x, y, kind } of nodes)
    assert.ok(difference(await picture(x, y), light.kind[kind]) <= 3, `kind ${kind}: ${await picture(x, y)}`);
  await set(page, { deform: 0 });
});
