// Opens a page from the disk and asserts what is painted. Usage: node page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { difference, painted, saved } from "./browser.mjs";
import { rgb, runTests, settle, tipOf, zoom } from "./run.mjs";

const tests = [];
const test = (name, run) => tests.push({ name, run });

const colour = (page, mode) => page.selectOption('[data-pick="colour"]', mode);
const click = (page, group, value) => page.click(`[data-choice="${group}"] [data-value="${value}"]`);

/** Place of grain g on the page, its radius in pixels, and its material. */
const grain = (page, g) =>
  page.evaluate((k) => {
    const { view, sample } = window.arenite,
      box = view.canvas.getBoundingClientRect();
    const [x, y] = view.camera.toScreen(view.snapshot.x[k], view.snapshot.y[k]);
    return {
      x: x + box.left,
      y: y + box.top,
      radius: sample.radius[k] * view.camera.scale,
      material: sample.material[k],
      id: sample.id[k],
    };
  }, g);

/** Middle of the strongest chain between two grains of these types, and what it says. */
const chain = (page, pick) =>
  page.evaluate((which) => {
    const { view, sample } = window.arenite,
      box = view.canvas.getBoundingClientRect(),
      { snapshot } = view;
    const { i, j, fn } = snapshot.contacts;
    const inside = [...fn.keys()].filter((c) => j[c] < sample.count && (which === "tension" ? fn[c] < 0 : fn[c] > 0));
    const c = inside.reduce((best, k) => (Math.abs(fn[k]) > Math.abs(fn[best]) ? k : best));
    const [x, y] = view.camera.toScreen(
      (snapshot.x[i[c]] + snapshot.x[j[c]]) / 2,
      (snapshot.y[i[c]] + snapshot.y[j[c]]) / 2,
    );
    return { x: x + box.left, y: y + box.top, ids: [sample.id[i[c]], sample.id[j[c]]], fn: fn[c] };
  }, pick);

const light = {
  page: rgb("#f6f5f2"),
  card: rgb("#ffffff"),
  materials: [rgb("#5b8fc9"), rgb("#f0b44c")],
  strong: rgb("#14191f"),
  tension: rgb("#d81b60"),
};

test("grains carry their material's colour", async (page) => {
  await click(page, "chains", "off");
  await settle(page);
  const picture = await painted(page);
  for (const g of [0, 1, 2, 3, 40, 41, 150, 151]) {
    const { x, y, material } = await grain(page, g);
    assert.ok(difference(await picture(x, y), light.materials[material]) <= 2, `grain ${g}: ${await picture(x, y)}`);
  }
});

test("the legend has the colours of the grains, which are paler under force chains", async (page) => {
  const alone = await page.evaluate(() => {
    const { view, sample } = window.arenite;
    return [...sample.radius.keys()].find((g) => sample.coordination(view.snapshot, g) === 0);
  });
  const { x, y, material } = await grain(page, alone);
  for (const [chains, pale] of [
    ["all", true],
    ["off", false],
  ]) {
    await click(page, "chains", chains);
    await settle(page);
    const picture = await painted(page),
      box = await page.locator("svg.key circle").nth(material).boundingBox();
    const [swatch, seen] = [await picture(box.x + box.width / 2, box.y + box.height / 2), await picture(x, y)];
    assert.ok(difference(swatch, seen) <= 3, `chains ${chains}: ${swatch} is not ${seen}`);
    assert.equal(difference(swatch, light.materials[material]) > 20, pale);
  }
});

test("the space between the wall and the page is empty", async (page) => {
  const box = await page.locator("canvas.grains").boundingBox();
  assert.ok(difference(await (await painted(page))(box.x + 3, box.y + 3), light.card) <= 1);
});

test("another colouring paints other colours", async (page) => {
  const { x, y } = await grain(page, 0);
  const before = await (await painted(page))(x, y);
  for (const mode of ["stress", "size"]) {
    await colour(page, mode);
    await settle(page);
    assert.ok(difference(await (await painted(page))(x, y), before) > 30, `mode ${mode} looks as before`);
  }
  await colour(page, "material");
  await settle(page);
  assert.ok(difference(await (await painted(page))(x, y), before) <= 2);
});

/** A grain of the row nearest to a height, as a share of the sample's. */
const grainAt = (page, share) =>
  page.evaluate((wanted) => {
    const { view } = window.arenite,
      { y } = view.snapshot,
      high = Math.max(...y);
    return y.reduce((best, v, g) => (Math.abs(v / high - wanted) < Math.abs(y[best] / high - wanted) ? g : best), 0);
  }, share);

const viridis = async (page, t) => rgb(await page.evaluate((share) => window.arenite.theme.maps.viridis(share), t));

test("velocity, rotation, pressure and deviator have colours of their own, as in their scales", async (page) => {
  await click(page, "chains", "off");
  for (const mode of ["pressure", "deviator", "rotation", "spin", "displacement", "coordination", "friction"]) {
    await colour(page, mode);
    await settle(page);
    assert.equal(await page.locator('[data-pick="map"]').isVisible(), true, mode);
  }
  await colour(page, "speed");
  await settle(page);
  const top = await page.locator('[data-range="high"]').inputValue(),
    picture = await painted(page);
  for (const share of [0.2, 0.5, 0.8]) {
    const g = await grainAt(page, share),
      { x, y } = await grain(page, g);
    const speed = await page.evaluate((k) => window.arenite.view.snapshot.vx[k], g),
      unit = await page.locator(".colour-range .name").last().innerText();
    const faded = await viridis(page, Math.min(1, speed / (Number(top) * (unit === "mm/s" ? 1e-3 : 1))));
    assert.ok(difference(await picture(x, y), faded) <= 5, `${share}: ${await picture(x, y)} is not ${faded}`);
  }
});

test("the reader chooses the map and the range, which the page's address keeps", async (page) => {
  const g = await grainAt(page, 0.5),
    place = await grain(page, g),
    before = await (await painted(page))(place.x, place.y);
  await page.selectOption('[data-pick="map"]', "grey");
  await settle(page);
  const [r, green, b] = await (await painted(page))(place.x, place.y);
  assert.ok(
    Math.max(Math.abs(r - green), Math.abs(green - b)) < 14 && difference([r, green, b], before) > 20,
    `${[r, green, b]}`,
  );
  const high = page.locator('[data-range="high"]'),
    usual = Number(await high.inputValue());
  await high.fill(String(usual / 100));
  await high.press("Enter");
  await settle(page);
  const dark = await (await painted(page))(place.x, place.y);
  assert.ok(Math.max(...dark) < 60, `a grain beyond the range is ${dark}`);
  await page.click('[data-toggle="log"]');
  await settle(page);
  assert.ok(Number(await page.locator('[data-range="low"]').inputValue()) > 0);
  const address = await page.evaluate(() => window.location.hash);
  assert.match(address, /colour=speed/);
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await page.waitForTimeout(200);
  assert.equal(await page.locator('[data-pick="colour"]').inputValue(), "speed");
  assert.equal(await page.locator('[data-pick="map"]').inputValue(), "grey");
  assert.equal(Number(await high.inputValue()), usual / 100);
  await page.click('[data-toggle="usual"]');
  assert.equal(Number(await high.inputValue()), usual);
  await colour(page, "material");
  await click(page, "chains", "all");
  assert.equal(await page.evaluate(() => window.location.hash), "");
});

test("a click on a row of the table marks its grain everywhere, and a click on the picture its row", async (page) => {
  await click(page, "chains", "off");
  const rows = page.locator(".grains-rows tr[data-grain]");
  await page.locator(".grain-table").scrollIntoViewIfNeeded();
  assert.ok(
    (await rows.count()) < (await page.evaluate(() => window.arenite.sample.count)),
    "rows out of sight are made",
  );
  await page.click('.grains-rows th button:has-text("d")');
  const largest = Number(await rows.first().getAttribute("data-grain")),
    radii = await page.evaluate(() => [...window.arenite.sample.radius]);
  assert.equal(radii[largest], Math.max(...radii));
  await rows.first().click();
  assert.equal(await page.evaluate(() => window.arenite.state.get("selected")), largest);
  assert.equal(await page.locator(".stage .selected").count(), 1);
  for (const figure of ["grain-scatter", "sigma-norm", "size-curve"]) {
    await page.locator(`[data-figure="${figure}"]`).scrollIntoViewIfNeeded();
    await settle(page);
    assert.ok((await page.locator(`[data-figure="${figure}"] .selected`).count()) > 0, figure);
  }
  await page.evaluate(() => window.scrollTo(0, 0));
  const other = await grain(page, 30);
  await page.mouse.click(other.x, other.y);
  assert.equal(await page.locator('.grains-rows tr[aria-selected="true"]').getAttribute("data-grain"), "30");
  const { x, y, radius } = await grain(page, 30);
  await page.mouse.move(2, 2);
  await settle(page);
  const picture = await painted(page),
    rim = await picture(x + radius + 1, y);
  assert.ok(difference(rim, rgb("#a4522a")) < 60, `the ring is ${rim}`);
  await page.locator(".grains-rows").focus();
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await page.evaluate(() => window.arenite.state.get("selected")), 30);
  await page.mouse.click(other.x, other.y);
  await page.mouse.click(other.x, other.y);
  assert.equal(await page.evaluate(() => window.arenite.state.get("selected")), null);
  await page.mouse.move(2, 2);
  await click(page, "chains", "all");
});

test("the table of grains and the figures are saved as tables of numbers", async (page) => {
  const table = (await saved(page, '.grain-table [data-save="csv"]')).toString("utf8").trim().split("\n"),
    heads = table[0].split(",");
  assert.equal(table.length - 1, await page.evaluate(() => window.arenite.sample.count));
  assert.ok(
    ["id", "material", "size_m", "pressure_Pa", "deviator_Pa", "vx_m_s", "spin_rad_s"].every((head) =>
      heads.includes(head),
    ),
    heads.join(),
  );
  const row = table[1].split(","),
    g = await page.evaluate((id) => window.arenite.sample.id.indexOf(id), Number(row[0]));
  assert.equal(Number(row[heads.indexOf("vx_m_s")]), await page.evaluate((k) => window.arenite.view.snapshot.vx[k], g));
  const curve = (await saved(page, '[data-figure="size-curve"] [data-save="csv"]')).toString("utf8").trim().split("\n");
  assert.equal(curve[0], 'of,"diameter, mm","passing, %"');
  const last = curve
    .filter((line) => line.startsWith("measured"))
    .at(-1)
    .split(",");
  assert.ok(Math.abs(Number(last[1]) - 16.4) < 1e-4 && Number(last[2]) === 100, last.join());
  const rose = (await saved(page, '[data-figure="fabric"] [data-save="csv"]')).toString("utf8").trim().split("\n");
  assert.equal(rose.length, 1 + 18 * (await page.locator('[data-figure="fabric"] .drawing > svg > g').count()));
  const cells = (await saved(page, '[data-figure="coarse-fields"] [data-save="csv"]'))
    .toString("utf8")
    .trim()
    .split("\n");
  assert.match(cells[0], /^"x, m","y, m",\u03c6,/);
});

test("coarse-grained fields are painted, and another one looks otherwise", async (page) => {
  const card = page.locator('[data-figure="coarse-fields"]'),
    image = () => card.locator("image").getAttribute("href");
  await card.scrollIntoViewIfNeeded();
  await settle(page);
  const speed = await image();
  assert.ok((await card.locator(".arrows path").count()) > 5);
  await card.locator("select").selectOption("solid_fraction");
  await settle(page);
  assert.notEqual(await image(), speed);
  assert.equal(await card.locator(".arrows").count(), 0);
  await card.locator("select").selectOption("speed");
  await page.evaluate(() => window.scrollTo(0, 0));
});

test("whoever does not see the page is told what is there, and every button has a name of its own", async (page) => {
  const names = await page
    .locator("button:visible")
    .evaluateAll((all) => all.map((b) => (b.getAttribute("aria-label") ?? b.textContent).trim()));
  assert.ok(names.every(Boolean), "a button has no name");
  const saves = names.filter((name) => name.startsWith("Save")),
    twice = saves.filter((name, k) => saves.indexOf(name) !== k);
  assert.ok(saves.length > 30 && twice.length === 0, twice.join("; "));
  assert.equal(await page.locator("canvas.grains").getAttribute("role"), "img");
  for (const svg of await page.locator("[data-figure] .drawing > svg").all())
    assert.equal(await svg.getAttribute("role"), "img");
});

test("on paper the page is white, has no controls, and no card is cut by a page", async (page) => {
  await page.emulateMedia({ media: "print" });
  const seen = (selector) => page.locator(selector).first().isVisible();
  for (const gone of [".controls", ".save", ".timeline input", "button.theme", ".grain-table"])
    assert.equal(await seen(gone), false, gone);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.ok(
    (
      await page.locator(".card:visible").evaluateAll((all) => all.map((card) => getComputedStyle(card).breakInside))
    ).every((v) => v === "avoid"),
  );
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 20000);
  await page.emulateMedia({ media: null });
  await settle(page);
});

test("force chains are painted, tension in its own colour, and the filters hide them", async (page) => {
  await click(page, "chains", "all");
  await settle(page);
  const strong = await chain(page, "push"),
    pull = await chain(page, "tension");
  let picture = await painted(page);
  assert.ok(
    difference(await picture(strong.x, strong.y), light.strong) < 40,
    `strong: ${await picture(strong.x, strong.y)}`,
  );
  const [r, g, b] = await picture(pull.x, pull.y);
  assert.ok(r > g + 50 && b > g, `tension: ${[r, g, b]}`);
  await click(page, "chains", "weak");
  await settle(page);
  picture = await painted(page);
  assert.ok(difference(await picture(strong.x, strong.y), light.strong) > 80, "a strong chain is left among the weak");
  await click(page, "chains", "strong");
  const types = await page.locator(".types button[data-type]").all();
  for (const button of types)
    if ((await button.getAttribute("data-type")) !== "wall")
      await page.click(`.types button[data-type="${await button.getAttribute("data-type")}"]`);
  await settle(page);
  picture = await painted(page);
  assert.ok(
    difference(await picture(strong.x, strong.y), light.strong) > 80,
    "a type that is switched off is still drawn",
  );
  for (const type of await page
    .locator(".types button[data-type]")
    .evaluateAll((all) => all.filter((b) => b.ariaPressed === "false").map((b) => b.dataset.type)))
    await page.click(`.types button[data-type="${type}"]`);
  await click(page, "chains", "all");
});

test("hovering tells a grain's and a contact's numbers", async (page) => {
  const strong = await chain(page, "push");
  await page.mouse.move(strong.x, strong.y);
  const contact = await page.locator(".tooltip").innerText();
  for (const id of strong.ids) assert.ok(contact.includes(String(id)), contact);
  assert.match(contact, /Fn/);
  await click(page, "chains", "off");
  const { x, y, id, radius } = await grain(page, 20);
  await page.mouse.move(x + 0.3 * radius, y);
  const words = await page.locator(".tooltip").innerText();
  assert.ok(words.includes(`Grain ${id}`), words);
  assert.match(words, /diameter\s+1[06]\.\d+/);
  assert.match(words, /contacts z/);
  await page.mouse.move(2, 2);
  assert.equal(await page.locator(".tooltip").isVisible(), false);
  await click(page, "chains", "all");
});

test("the wheel over the picture scrolls the page, leaves the picture, and a line says how to zoom", async (page) => {
  const hint = page.locator(".hint"),
    opacity = () => hint.evaluate((line) => Number(getComputedStyle(line).opacity));
  assert.equal(await opacity(), 0);
  const { x, y, radius } = await grain(page, 20);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => window.scrollY > 60);
  assert.equal((await grain(page, 20)).radius, radius);
  assert.match(await hint.textContent(), /Ctrl \+ wheel zooms/);
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".hint")).opacity === "1");
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".hint")).opacity === "0");
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.waitForFunction(() => window.scrollY === 0);
});

test("Ctrl and the wheel zoom about the pointer without scrolling; a double click shows all again", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await zoom(page, 2);
  const after = await grain(page, 20);
  assert.ok(Math.abs(after.radius / before.radius - 2) < 1e-9, `${before.radius} -> ${after.radius}`);
  assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 1);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  await page.mouse.dblclick(before.x, before.y);
  await settle(page);
  assert.ok(Math.abs((await grain(page, 20)).radius - before.radius) < 1e-6);
  await page.mouse.move(2, 2);
});

test("a touchpad's pinch, many small turns with Ctrl, zooms as far as fingers move", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await page.keyboard.down("Control");
  for (let k = 0; k < 50; ++k) await page.mouse.wheel(0, -1);
  await page.keyboard.up("Control");
  await settle(page);
  assert.ok(Math.abs((await grain(page, 20)).radius / before.radius - 2) < 1e-6);
  await page.mouse.dblclick(before.x, before.y);
});

test("at the end of its range the zoom does not zoom the page", async (page) => {
  const { x, y } = await grain(page, 20);
  await page.mouse.move(x, y);
  await zoom(page, -6);
  const wide = await page.evaluate(() => [window.innerWidth, devicePixelRatio]);
  const kept = await page.locator("canvas.grains").evaluate((canvas) => {
    const turn = new WheelEvent("wheel", { deltaY: 100, ctrlKey: true, bubbles: true, cancelable: true });
    canvas.dispatchEvent(turn);
    return turn.defaultPrevented;
  });
  assert.ok(kept);
  assert.deepEqual(await page.evaluate(() => [window.innerWidth, devicePixelRatio]), wide);
  await page.mouse.dblclick(x, y);
});

test("dragging moves the picture with the pointer, and a drag is no click", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await page.mouse.down();
  await page.mouse.move(before.x + 20, before.y + 10);
  await page.mouse.move(before.x + 60, before.y - 35);
  assert.equal(await page.locator(".tooltip").isVisible(), false);
  await page.mouse.up();
  await settle(page);
  const after = await grain(page, 20);
  assert.ok(
    Math.hypot(after.x - before.x - 60, after.y - before.y + 35) < 1e-6,
    `${after.x - before.x}, ${after.y - before.y}`,
  );
  await page.locator("canvas.grains").focus();
  await page.keyboard.press("0");
  await settle(page);
  assert.ok(Math.hypot((await grain(page, 20)).x - before.x, (await grain(page, 20)).y - before.y) < 1e-9);
});

test("keys zoom, move what is zoomed, and show all", async (page) => {
  const before = await grain(page, 20);
  await page.locator("canvas.grains").focus();
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.equal((await grain(page, 20)).x, before.x);
  await page.keyboard.press("+");
  await settle(page);
  const larger = await grain(page, 20),
    width = await page.evaluate(() => window.arenite.view.camera.width);
  assert.ok(Math.abs(larger.radius / before.radius - 1.25) < 1e-9);
  await page.keyboard.press("ArrowRight");
  await settle(page);
  const moved = await grain(page, 20);
  assert.ok(
    Math.abs(larger.x - moved.x - 0.1 * width) < 1e-6 && Math.abs(larger.y - moved.y) < 1e-9,
    `${larger.x} -> ${moved.x}`,
  );
  await page.keyboard.press("-");
  await page.keyboard.press("Escape");
  await settle(page);
  assert.ok(Math.hypot((await grain(page, 20)).x - before.x, (await grain(page, 20)).y - before.y) < 1e-9);
});

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

await runTests(process.argv[2], tests);
