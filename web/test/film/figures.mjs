// Pointer and figures of the page of a film; themes and narrow screens.
import assert from "node:assert/strict";
import { difference, painted, saved } from "../browser.mjs";
import { settle, tipOf, zoom } from "../run.mjs";
import { set, show, tab, onPage, grains, contacts, brightness } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("hovering tells a pixel's and a grain's numbers, or a contact's with its error", async (page) => {
  await show(page, { grains: "rims" });
  const [grain] = (await grains(page)).slice(40),
    place = await onPage(page, grain.x, grain.y);
  await page.mouse.move(place.x, place.y);
  const words = await page.locator(".tooltip:visible").innerText();
  assert.match(words, new RegExp(`Grain ${grain.id}, (POM|HDPE)`));
  for (const part of [
    /\u03c3hyd\s*\u2212[\d.]+ \u00b1 [\d.]+\u202f[Mk]Pa/,
    /amplitude\s*[\d.]+\u202fmK/,
    /picture\s*29\d\.\d{3}\u202fK/,
    /motion x, y/,
    /radius\s*[\d.]+\u202fpx, [\d.]+\u202fmm/,
  ])
    assert.match(words, part);
  const corner = await onPage(page, 3, 1);
  await page.mouse.move(corner.x, corner.y);
  assert.match(await page.locator(".tooltip:visible").innerText(), /Column 3, row 1/);
  await set(page, { forces: true });
  await settle(page);
  const [strongest] = (await contacts(page)).filter(({ uncertain }) => !uncertain).sort((a, b) => b.fn - a.fn),
    [x1, y1, x2, y2] = strongest.ends;
  const middle = await onPage(page, (x1 + x2) / 2, (y1 + y2) / 2);
  await page.mouse.move(middle.x, middle.y);
  const told = await page.locator(".tooltip:visible").innerText();
  assert.match(told, /Contact \d+\u2009\u2013\u2009\d+/);
  assert.match(told, /Fn\s*[\d.]+ \u00b1 [\d.]+\u202fk?N/);
});

test("zoomed in, a pixel is a square of one colour; 0 shows all again", async (page) => {
  await show(page, { map: "amplitude" });
  const before = await page.evaluate(() => window.arenite.film.view.camera.scale),
    [{ x, y }] = (await grains(page)).slice(130);
  const start = await onPage(page, Math.round(x), Math.round(y));
  await page.mouse.move(start.x, start.y);
  await zoom(page, 10);
  await page.mouse.move(2, 2);
  await settle(page);
  const scale = await page.evaluate(() => window.arenite.film.view.camera.scale),
    middle = await onPage(page, Math.round(x), Math.round(y));
  assert.ok(scale > 30, `${scale} px a pixel`);
  const picture = await painted(page),
    colour = await picture(middle.x, middle.y);
  for (const [dx, dy] of [
    [-0.42, -0.42],
    [0.42, -0.42],
    [-0.42, 0.42],
    [0.42, 0.42],
  ])
    assert.ok(difference(await picture(middle.x + dx * scale, middle.y + dy * scale), colour) <= 1, `${dx}, ${dy}`);
  await page.locator("canvas.film:visible").focus();
  await page.keyboard.press("0");
  await settle(page);
  assert.ok(Math.abs((await page.evaluate(() => window.arenite.film.view.camera.scale)) - before) < 1e-9 * before);
});

test("every figure is drawn and saved as a whole SVG, and its choices redraw it", async (page) => {
  const names = await page.locator("[data-figure]:visible").evaluateAll((all) => all.map((f) => f.dataset.figure));
  assert.deepEqual(names, [
    "film-maps",
    "film-simulation",
    "film-tails",
    "film-orientations",
    "film-fit",
    "film-forces",
    "film-certainty",
    "film-stresses",
  ]);
  for (const name of names) {
    const source = (await saved(page, `[data-figure="${name}"] [data-save="svg"]:visible`)).toString("utf8");
    assert.ok(source.match(/<(path|rect|circle|line)/g).length > 5, `${name} is bare`);
    const words = source.replace(/"data:[^"]*"/g, ""); // without pictures, whose letters mean nothing
    assert.doesNotMatch(words, /NaN|undefined|var\(--/, name);
  }
  for (const [name, key, value] of [
    ["film-simulation", "companion", "state"],
    ["film-simulation", "over", "unit"],
    ["film-forces", "component", "ft"],
  ]) {
    const drawing = page.locator(`[data-figure="${name}"]:visible .drawing`),
      first = await drawing.innerHTML();
    await page.click(`[data-figure="${name}"] [data-choice="${key}"]:visible [data-value="${value}"]`);
    await settle(page);
    assert.notEqual(await drawing.innerHTML(), first, `${name}: ${key}`);
  }
});

test("film and simulation are compared grain by grain, with the correlation in the corner", async (page) => {
  await set(page, { companion: "peak_to_peak", over: "mean" });
  await settle(page);
  const { dots, whiskers, words } = await page
    .locator('[data-figure="film-simulation"]:visible .drawing')
    .evaluate((box) => ({
      dots: box.querySelectorAll("circle").length,
      whiskers: box.querySelectorAll('g[aria-label="rule"] line').length,
      words: box.textContent,
    }));
  assert.equal(dots, 260);
  assert.equal(whiskers, 260);
  const said = Number(words.match(/r = (0\.\d+)/)[1]);
  const own = await page.evaluate(() => {
    const {
        stresses: { film, simulation_peak_to_peak: simulation },
        grains: { considered },
      } = window.arenite.film.film,
      mean = (v) => v.reduce((a, b) => a + b, 0) / v.length;
    const [a, b] = [film.sigma_hyd, simulation.sigma_hyd].map((v) => Array.from(v).filter((_, g) => considered[g])),
      [ma, mb] = [mean(a), mean(b)];
    const sum = (f) => a.reduce((total, _, g) => total + f(a[g] - ma, b[g] - mb), 0);
    return sum((p, q) => p * q) / Math.sqrt(sum((p) => p * p) * sum((_, q) => q * q));
  });
  assert.ok(Math.abs(said - own) < 2e-3, `${said} is not ${own}`);
  assert.equal(await page.locator('[data-figure="film-maps"]:visible circle').count(), 3 * 260);
  const tables = await page.locator(".numbers:visible").allInnerTexts();
  assert.match(
    tables.join("\n"),
    /Experiment and simulation[\s\S]*Simulation, peak to peak[\s\S]*HDPE[\s\S]*Agreement/,
  );
});

test("contact orientations in film and simulation stand side by side on one scale", async (page) => {
  const roses = await page.locator('[data-figure="film-orientations"]:visible [data-set]').evaluateAll((all) =>
    all.map((g) => ({
      name: g.dataset.set,
      petals: g.querySelectorAll("path[fill-opacity]").length,
      radii: [...g.querySelectorAll("circle")].map((c) => Number(c.getAttribute("r"))),
      words: g.textContent,
    })),
  );
  assert.deepEqual(
    roses.map((r) => r.name),
    ["film", "simulation"],
  );
  assert.deepEqual(roses[0].radii, roses[1].radii);
  const { said, drawn } = await page.evaluate(() => ({
    said: window.arenite.film.film.declared.at("contact_orientations"),
    drawn: [window.arenite.film.film.about.figures["film-orientations"]].flat()[0].roses,
  }));
  for (const [k, set] of [said.film, said.simulation].entries()) {
    assert.equal(roses[k].petals, 36);
    assert.equal(drawn[k].count, set.contacts);
    const shown = Number(roses[k].words.match(/= (0\.\d+)/)[1]);
    assert.ok(Math.abs(shown - set.a_c.value) < 0.01, `${roses[k].words}: ${set.a_c.value}`);
    assert.match(roses[k].words, /\u00b0|noise/);
  }
  assert.match(
    await page.locator('[data-figure="film-simulation"]:visible .caption').innerText(),
    /0\.4 to 0\.5.*friction.*history is lost/,
  );
});

test("forces carry error bars of one standard error", async (page) => {
  await set(page, { component: "fn" });
  await settle(page);
  const { lines, y0, y1, count } = await page
    .locator('[data-figure="film-forces"]:visible .drawing')
    .evaluate((box) => {
      const rules = [...box.querySelectorAll('g[aria-label="rule"] line')].filter(
          (l) => l.getAttribute("x1") === l.getAttribute("x2"),
        ),
        svg = box.querySelector("svg");
      const { apply, invert } = svg.scale("y");
      return {
        lines: rules.length,
        y0: invert(Number(rules[0].getAttribute("y1"))),
        y1: invert(Number(rules[0].getAttribute("y2"))),
        count: apply && window.arenite.film.film.contacts.count,
      };
    });
  assert.equal(lines, count);
  const [top] = await page.evaluate(() => {
    const { fn, fn_error: error } = window.arenite.film.film.contacts;
    return Array.from(fn, (f, c) => ({ f, e: error[c] })).sort((a, b) => b.f - a.f);
  });
  assert.ok(
    Math.abs(Math.abs(y1 - y0) - (2 * top.e) / 1e3) < 0.02 * Math.abs(y1 - y0),
    `${y1 - y0} kN for twice ${top.e} N`,
  );
});

test("the pointer on a chart names the grain or the contact with its error and unit", async (page) => {
  await set(page, { companion: "peak_to_peak", over: "unit" });
  await settle(page);
  const grain = await tipOf(page, "film-simulation"),
    contact = await tipOf(page, "film-forces");
  assert.match(
    grain.join("\n"),
    new RegExp(
      "^Grain \\d+, (POM|HDPE)\nsimulation, \u2212\u03c3hyd \u2212?[\\d.]+\u202f[kM]Pa\n" +
        "film, \u2212\u03c3hyd \u2212?[\\d.]+ \u00b1 [\\d.]+\u202f[kM]Pa$",
    ),
  );
  assert.match(
    contact.join("\n"),
    /^Contact \d+\u2009\u2013\u2009.*\nrank \d+\nFn \u2212?[\d.]+ \u00b1 [\d.]+\u202fk?N$/,
  );
  await set(page, { over: "mean" });
  await page.mouse.move(2, 2);
});

test("the picture is saved as SVG with its map inside and as PNG at twice the size", async (page) => {
  await show(page, { grains: "material", forces: true });
  await page.evaluate(() => window.scrollTo(0, 0));
  const svg = (await saved(page, '.sample:visible .save:has-text("SVG")')).toString("utf8");
  assert.match(svg, /<image[^>]*href="data:image\/png;base64,[A-Za-z0-9+/=]{2000,}"/);
  assert.ok(svg.match(/<circle/g).length >= 2 * 260);
  assert.doesNotMatch(svg.replace(/base64,[^"]*/, ""), /NaN|undefined/);
  const png = await saved(page, '.sample:visible .save:has-text("PNG")');
  assert.equal(
    png.readUInt32BE(16),
    Math.round(2 * (await page.evaluate(() => window.arenite.film.view.camera.width))),
  );
});

test("a film of maps alone says what it cannot show", async (page) => {
  await tab(page, "Maps");
  assert.equal(await page.locator("[data-figure]:visible").count(), 0);
  assert.match(await page.locator(".missing:visible").innerText(), /No grains were found in this film/);
  assert.deepEqual(await page.locator('[data-choice="map"]:visible button').allInnerTexts(), [
    "Amplitude",
    "Phase",
    "Signed",
    "Noise",
    "Residual",
  ]);
  assert.equal(await page.locator('[data-choice="grains"]:visible').count(), 0);
  const place = await onPage(page, 60, 60);
  await page.mouse.move(place.x, place.y);
  assert.match(await page.locator(".tooltip:visible").innerText(), /Column 60, row 60/);
  await tab(page, "Film");
});

test("stresses of grains alone have their figures, and what is missing is said", async (page) => {
  await tab(page, "Stresses");
  assert.deepEqual(await page.locator("[data-figure]:visible").evaluateAll((all) => all.map((f) => f.dataset.figure)), [
    "film-tails",
    "film-stresses",
  ]);
  assert.match(await page.locator(".missing:visible").innerText(), /forces were not inferred.*No simulation/);
  assert.equal(await page.locator('[data-figure="film-stresses"]:visible circle').count(), 260);
  await tab(page, "Film");
});

test("the dark theme darkens page and map", async (page) => {
  await show(page, { map: "in_phase" });
  await page.click("button.theme");
  await settle(page);
  const picture = await painted(page),
    corner = await onPage(page, 2, 2);
  assert.ok(Math.max(...(await picture(2, 400))) < 40);
  assert.ok(brightness(await picture(corner.x, corner.y)) < 70, `outside is ${await picture(corner.x, corner.y)}`);
  await page.click("button.theme");
});

test("on a narrow screen everything stands in one column and nothing is cut off", async (page) => {
  await page.setViewportSize({ width: 420, height: 900 });
  for (const title of ["Packing", "Maps", "Stresses", "Film"]) {
    await tab(page, title);
    const words = await page
      .locator('[data-figure="film-fit"]:visible svg > text')
      .evaluateAll((all) =>
        all.map((t) => t.getBoundingClientRect()).map(({ left, right, top }) => [left, right, top]),
      );
    for (const [left, right, top] of words)
      assert.ok(
        words.every(([l, r, t]) => t !== top || l === left || l >= right || r <= left),
        `names of maps overlap at ${left}`,
      );
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 420, `${title} is ${wide} px wide`);
  }
});
