// Opens the page of a study and asserts what is painted. Usage: node study_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { saved } from "./browser.mjs";
import { runTests, settle, tipOf } from "./run.mjs";

const tests = [];
const test = (name, run) => tests.push({ name, run });

const drawing = (page, id) =>
  page.evaluate((figure) => {
    const svg = document.querySelector(`[data-figure="${figure}"] .drawing > svg`);
    return (
      svg && {
        dots: svg.querySelectorAll("circle").length,
        lines: svg.querySelectorAll("path[fill=none], g[fill=none] path").length,
        text: [...svg.querySelectorAll("text")].map((node) => node.textContent),
        outside: [...svg.querySelectorAll("circle")].some((dot) => {
          const a = dot.getBoundingClientRect(),
            b = svg.getBoundingClientRect();
          return a.left < b.left || a.right > b.right || a.top < b.top || a.bottom > b.bottom;
        }),
      }
    );
  }, id);

test("points lie inside their figure, with a label on each axis and what the source says", async (page) => {
  const { dots, text, outside } = await drawing(page, "points");
  assert.equal(dots, 4);
  assert.equal(outside, false);
  for (const label of ["gamma", "z", "source: 15"]) assert.ok(text.includes(label), `${label} is missing in ${text}`);
});

test("a link leads to its figure", async (page) => {
  assert.equal(await page.evaluate(() => document.getElementById("rose").dataset.figure), "rose");
});

test("the key names a curve for each value", async (page) => {
  const names = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="points"] .entry b')].map((node) => node.textContent),
  );
  assert.deepEqual(names, ["full", "η = 0.2"]);
});

test("densities are lines without dots", async (page) => {
  const { dots, lines } = await drawing(page, "density");
  assert.equal(dots, 0);
  assert.ok(lines >= 1);
});

test("densities of several samples stand in a band, points of densities have bars", async (page) => {
  const bands = (id) =>
    page.evaluate(
      (figure) => document.querySelectorAll(`[data-figure="${figure}"] .drawing [fill-opacity="0.2"]`).length,
      id,
    );
  assert.equal(await bands("density"), 1);
  assert.equal(await bands("points"), 0);
  assert.ok(
    (await page.evaluate(
      () => document.querySelectorAll('[data-figure="beside"] .drawing [aria-label=rule] line').length,
    )) > 0,
  );
});

test("a caption says what is shown of the scatter and over how many samples", async (page) => {
  const said = (id) =>
    page.evaluate((figure) => document.querySelector(`[data-figure="${figure}"] .caption`).textContent, id);
  assert.match(await said("density"), /Bands: standard error over 8 samples\.$/);
  assert.match(await said("source"), /Bars: standard deviation over 2 samples\.$/);
});

test("numbers of contacts have round rings and no isotropic one", async (page) => {
  const { texts, dashed } = await page.evaluate(() => {
    const svg = document.querySelector('[data-figure="counts"] .drawing > svg');
    return {
      texts: [...svg.querySelectorAll("text")].map((node) => node.textContent),
      dashed: svg.querySelectorAll("circle[stroke-dasharray]").length,
    };
  });
  assert.equal(dashed, 0);
  for (const label of ["1", "2", "3", "Nc"]) assert.ok(texts.includes(label), `${label} is missing in ${texts}`);
});

test("the source's points are crosses and other runs are diamonds, and the key says so", async (page) => {
  const entries = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="source"] .entry')].map((node) => [
      node.textContent,
      node.querySelectorAll("path").length,
    ]),
  );
  assert.deepEqual(entries, [
    ["", 0],
    ["0.2", 1],
    ["T", 1],
  ]);
  assert.equal((await drawing(page, "source")).dots, 2);
});

test("a rose has an outline for each curve, dashed for the second of a value", async (page) => {
  const dashes = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="rose"] .drawing path:not(.scatter)')].map((node) =>
      node.getAttribute("stroke-dasharray"),
    ),
  );
  assert.deepEqual(dashes, [null, "6 3", null, "6 3"]);
});

test("a map has a cell with its value for every pair", async (page) => {
  const texts = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="map"] .drawing text')].map((node) => node.textContent),
  );
  assert.equal(await page.evaluate(() => document.querySelectorAll('[data-figure="map"] .drawing rect').length), 4);
  for (const value of ["12.5", "16.5", "full", "0.2"])
    assert.ok(texts.includes(value), `${value} is missing in ${texts}`);
});

test("a sample has its grains, the glued ones outlined, and a line for a contact that pulls", async (page) => {
  const paths = (id) =>
    page.evaluate(
      (figure) =>
        [...document.querySelectorAll(`[data-figure="${figure}"] .drawing path`)].map((node) =>
          node.getAttribute("fill"),
        ),
      id,
    );
  const forces = await paths("forces"),
    stresses = await paths("stresses");
  assert.equal(forces.filter((fill) => fill === "none").length, 2);
  assert.equal(forces.length, 4);
  assert.equal(stresses.length, 3);
});

test("grains have the colours and names of their materials, and the picture its width", async (page) => {
  const { names, caption, fills } = await page.evaluate(() => {
    const card = document.querySelector('[data-figure="grains"]');
    return {
      names: [...card.querySelectorAll(".entry b")].map((node) => node.textContent),
      caption: card.querySelector(".caption").textContent,
      fills: new Set(
        [...card.querySelectorAll(".drawing path[fill]")]
          .map((node) => node.getAttribute("fill"))
          .filter((fill) => fill !== "none"),
      ).size,
    };
  });
  assert.deepEqual(names, ["POM", "HDPE", "glued"]);
  assert.equal(fills, 2);
  assert.match(caption, /20 mm across/);
});

test("phases and the stress about a grain are painted node by node", async (page) => {
  const pixels = (id) =>
    page.evaluate(async (figure) => {
      const image = new Image();
      image.src = document.querySelector(`[data-figure="${figure}"] .drawing image`).getAttribute("href");
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      return {
        width: image.width,
        height: image.height,
        colours: new Set(Array.from({ length: data.length / 4 }, (_, k) => data.slice(4 * k, 4 * k + 3).join())).size,
      };
    }, id);
  assert.deepEqual(await pixels("phases"), { width: 4, height: 2, colours: 3 });
  assert.deepEqual(await pixels("zoom"), { width: 2, height: 1, colours: 2 });
  const names = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="phases"] .entry b')].map((node) => node.textContent),
  );
  assert.deepEqual(names, ["void", "matrix", "large grains"]);
});

test("broken bonds are dots in the colour of their type, which the key names", async (page) => {
  const { paths, names } = await page.evaluate(() => {
    const card = document.querySelector('[data-figure="cracks"]');
    return {
      paths: [...card.querySelectorAll(".drawing path")].map((node) => node.getAttribute("d").split("M").length - 1),
      names: [...card.querySelectorAll(".entry b")].map((node) => node.textContent),
    };
  });
  assert.deepEqual(paths, [2, 1]);
  assert.deepEqual(names, ["matrix", "large grains", "broken: matrix", "broken: interface"]);
});

test("what is not there yet is said in a sentence", async (page) => {
  const said = await page.evaluate(() => document.querySelector('[data-figure="film"] .nothing').textContent);
  assert.equal(said, "Not drawn: no film of this run was made.");
});

test("a fit is a dashed line over its density, without an entry of the key", async (page) => {
  const { dashes, entries } = await page.evaluate(() => {
    const card = document.querySelector('[data-figure="tails"]');
    return {
      dashes: [...card.querySelectorAll(".drawing [stroke-dasharray]")].map((node) =>
        node.getAttribute("stroke-dasharray"),
      ),
      entries: card.querySelectorAll(".entry").length,
    };
  });
  assert.deepEqual(dashes, ["6 3", "6 3"]); // the source's line and the fit
  assert.equal(entries, 0);
});

test("a film's points are hollow, in the colour of what was simulated", async (page) => {
  const dots = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="beside"] .drawing circle')].map((dot) =>
      [dot, dot.parentElement].map((node) => [node.getAttribute("fill"), node.getAttribute("stroke")]),
    ),
  );
  const of = (dot, k) => dot[0][k] ?? dot[1][k];
  assert.equal(dots.length, 6);
  assert.equal(of(dots[3], 1), of(dots[0], 0));
  assert.notEqual(of(dots[3], 0), of(dots[0], 0));
});

test("the pointer shows the numbers of a point with its error, and of a cell of a map", async (page) => {
  assert.match((await tipOf(page, "points")).join("\n"), /^(full|\u03b7 = 0\.2)\ngamma [\d.]+\nz [\d.]+/);
  assert.match((await tipOf(page, "map")).join("\n"), /^gamma (1|5)\n(full|0\.2)\n1\d\.\d/);
  await page.mouse.move(2, 2);
});

test("light and dark differ and both are drawn", async (page) => {
  const colour = () => page.evaluate(() => getComputedStyle(document.querySelector(".card")).backgroundColor);
  const light = await colour();
  await page.click("button.theme");
  await settle(page);
  assert.notEqual(await colour(), light);
  assert.equal((await drawing(page, "points")).dots, 4);
});

test("the table lists every run with values and main numbers; a click on a column header sorts it", async (page) => {
  const rows = page.locator(".runs tr[data-run]"),
    cells = async (k) =>
      (await rows.locator(`td:nth-child(${k})`).allInnerTexts()).map((cell) => Number(cell.split(" ")[0]));
  assert.equal(await rows.count(), 8);
  assert.deepEqual(await page.locator(".runs thead th").allInnerTexts(), ["gamma", "width", "seed", "status", "z"]);
  assert.equal(await rows.locator("td:first-child[title^='run ']").count(), 8);
  await page.click('.runs th button:text-is("z")');
  const rising = await cells(5);
  assert.deepEqual(
    rising,
    [...rising].sort((a, b) => a - b),
  );
  await page.click('.runs th button:text-is("z")');
  assert.deepEqual(await cells(5), [...rising].reverse());
  assert.equal(await page.locator('.runs th[aria-sort="descending"]').innerText(), "z");
  const table = (await saved(page, '.runs [data-save="csv"]')).toString("utf8").trim().split("\n");
  assert.equal(table[0], 'run,status,gamma,width,seed,z,"z, standard error"');
  assert.equal(table.length, 9);
});

await runTests(process.argv[2], tests);
