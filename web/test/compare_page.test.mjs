// Opens a page with tables of texts, as `arenite compare` makes it. Usage: node compare_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { runTests } from "./run.mjs";

const tests = [];
const test = (name, run) => tests.push({ name, run });

test("what one asks first stands before the figures, numbers behind them", async (page) => {
  const order = await page.evaluate(() =>
    [...document.querySelectorAll(".card")].map((card) => card.dataset.figure ?? card.getAttribute("aria-label")),
  );
  assert.deepEqual(order, ["Tests", "stress", "load"]);
});

test("rows beyond their errors are marked, the rest waits behind a summary", async (page) => {
  const card = page.locator('[aria-label="load"].card');
  assert.deepEqual(await card.locator("tr.marked td").allInnerTexts(), ["z", "3 ± 0.1"]);
  const colour = (row) => card.locator(row).evaluate((td) => getComputedStyle(td).backgroundColor);
  assert.notEqual(await colour("tr.marked td >> nth=0"), await colour("tbody tr:not(.marked) td >> nth=0"));
  assert.equal(await card.locator("details td >> nth=0").isVisible(), false);
  await card.locator("summary").click();
  assert.equal(await card.locator("summary").innerText(), "1 more");
  assert.equal(await card.locator("details td >> nth=0").isVisible(), true);
});

test("both results are lines of their colours", async (page) => {
  const names = await page.locator('[data-figure="stress"] .entry b').allInnerTexts();
  assert.deepEqual(names, ["A", "B"]);
  const strokes = await page.evaluate(() =>
    [...document.querySelectorAll('[data-figure="stress"] .entry line')].map((line) => line.getAttribute("stroke")),
  );
  assert.equal(new Set(strokes).size, 2);
});

await runTests(process.argv[2], tests);
