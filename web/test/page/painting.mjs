// What the page of a packing paints.
import assert from "node:assert/strict";
import { difference, painted, saved } from "../browser.mjs";
import { rgb, settle } from "../run.mjs";
import { click, grain, chain, light } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

const colour = (page, mode) => page.selectOption('[data-pick="colour"]', mode);

/** A grain of the row nearest to a height, as a share of the sample's. */
const grainAt = (page, share) =>
  page.evaluate((wanted) => {
    const { view } = window.arenite,
      { y } = view.snapshot,
      high = Math.max(...y);
    return y.reduce((best, v, g) => (Math.abs(v / high - wanted) < Math.abs(y[best] / high - wanted) ? g : best), 0);
  }, share);

const viridis = async (page, t) => rgb(await page.evaluate((share) => window.arenite.theme.maps.viridis(share), t));

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
    return [...sample.radius.keys()].find((g) => view.snapshot.coordination[g] === 0);
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
