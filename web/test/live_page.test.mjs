// Opens the page of a run under way, whose server is played here. Usage: node live_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { runTests } from "./run.mjs";

const tests = [];
const test = (name, run) => tests.push({ name, run });

const sample = { size: [20, 10], x: [5, 15], y: [5, 5], r: [5, 5], material: [0, 0], glued: [0, 0], materials: ["A"] };
const panel = (y) => ({
  x: { label: "strain" },
  y: { label: "q/p" },
  series: [{ name: "", colour: "strong", line: "solid", x: [0, 1, 2], y }],
});
const run = {
  title: "Biaxial test",
  folder: "out/a",
  life: "running",
  at: 1,
  status: { stage: 2, stages: 3, name: "shear", share: 0.25, step: 7, settles: true, increments: 0, seconds_left: 120 },
  stages: [{ name: "densify", outcome: "equilibrium" }],
  figures: [
    { id: "grains", title: "Grains", caption: "", sample: { ...sample, i: [0], j: [1], f: [1], tension: -0.001 } },
    { id: "test-curves", title: "Curves", caption: "", drawing: { panels: [panel([0, 1, 0.5])] } },
  ],
};

/** What the server answers from now on; waits until the page has asked. */
async function answered(page, state) {
  await page.evaluate((told) => {
    window.fetch = async (what, { method } = {}) => {
      window.asked = [...(window.asked ?? []), `${method ?? "GET"} ${what}`];
      return { ok: true, json: async () => told };
    };
    window.asked = [];
  }, state);
  await page.waitForFunction(() => window.asked.length > 0, null, { timeout: 10000 });
  await page.waitForTimeout(100);
}

test("a run under way has its grains, its curve and where it stands", async (page) => {
  await answered(page, run);
  assert.equal(await page.locator("h1").innerText(), "Biaxial test");
  assert.match(await page.locator(".now").innerText(), /^stage 3 of 3, shear, 25 %, step 7, about 2 min left$/);
  assert.equal(await page.locator('[role="progressbar"]').getAttribute("aria-valuenow"), "25");
  assert.equal(await page.locator('[data-figure="grains"] .drawing > svg path').count(), 2);
  assert.equal(await page.locator('[data-figure="test-curves"] .drawing > svg').count(), 1);
});

test("bodies have their rims, and boundaries and membranes are drawn, as on the page of a run", async (page) => {
  const rims = [
    { x: [0, 10, 5], y: [0, 0, 10] },
    { x: [10, 20, 20, 10], y: [0, 0, 10, 10] },
  ];
  const boundaries = [
    { x: [0, 20], y: [10, 10], closed: false, present: true },
    { x: [0, 20, 20], y: [0, 0, 5], closed: true, present: false },
  ];
  const grains = { id: "grains", title: "Grains", caption: "", sample: { ...sample, rims, boundaries } };
  await answered(page, { ...run, at: 1.5, figures: [grains] });
  const drawing = page.locator('[data-figure="grains"] .drawing > svg');
  const corners = (await drawing.locator("path").first().getAttribute("d")).match(/[ML]/g);
  assert.equal(corners.length, 7);
  assert.equal(await drawing.locator("polyline.boundary").getAttribute("stroke-dasharray"), null);
  assert.equal(await drawing.locator("polygon.boundary").getAttribute("stroke-dasharray"), "4 4");
  await answered(page, run);
});

test("figures are drawn anew when they have changed, and only then", async (page) => {
  const mark = () => page.evaluate(() => (document.querySelector('[data-figure="grains"]').dataset.seen = "yes"));
  const seen = () => page.evaluate(() => document.querySelector('[data-figure="grains"]').dataset.seen);
  await mark();
  await answered(page, run);
  assert.equal(await seen(), "yes");
  await answered(page, { ...run, at: 2 });
  assert.equal(await seen(), undefined);
});

/** Two spheres of which the upper one lies at a height, as the program tells of a state. */
function spheresAt(y) {
  const container = { corner: [0, 0, 0], size: [2, 4, 2], periodic: [false, false, false], tilt: 0, walls: [] };
  const state = {
    label: "now",
    time: 0.1,
    place: 0,
    count: 2,
    container,
    materials: [{ name: "glass" }],
    id: [1, 2],
    x: [1, 1],
    y: [0.5, y],
    z: [1, 1],
    radius: [0.5, 0.5],
    material: [0, 0],
    speed: [0, 1],
    quantities: { speed: { label: "Velocity", symbol: "|v|", unit: "m/s", magnitude: true, mean: 0.5 } },
  };
  const empty = "eJwDAAAAAAE=";
  return { id: "spheres", title: "Spheres now", spheres: { name: "fill", figures: {}, states: [state] }, block: empty };
}

test("spheres are one picture that stays as it was turned while they move", async (page) => {
  const curves = run.figures[1];
  await answered(page, { ...run, at: 5, figures: [spheresAt(3), curves] });
  const canvas = page.locator("canvas.spheres");
  await canvas.scrollIntoViewIfNeeded();
  await canvas.evaluate((one) => (one.dataset.seen = "yes"));
  await page.locator('[data-value="speed"]').click();
  await canvas.focus();
  for (let k = 0; k < 3; ++k) await page.keyboard.press("ArrowLeft");
  const shot = () => canvas.evaluate((one) => one.toDataURL());
  await page.waitForTimeout(400);
  const before = await shot();
  await answered(page, { ...run, at: 6, figures: [spheresAt(2), curves] });
  await page.waitForTimeout(400);
  assert.equal(await canvas.count(), 1);
  assert.equal(await canvas.getAttribute("data-seen"), "yes");
  assert.equal(await page.locator('[data-value="speed"]').getAttribute("aria-pressed"), "true");
  assert.notEqual(await shot(), before, "they have moved");
  await answered(page, { ...run, at: 7, figures: [spheresAt(3), curves] });
  await page.waitForTimeout(400);
  assert.equal(await shot(), before, "seen from the same side");
  assert.equal(await page.locator('[data-figure="test-curves"] .drawing > svg').count(), 1);
  await answered(page, { ...run, at: 8 });
  assert.equal(await canvas.count(), 0);
});

test("the button asks the run to stop", async (page) => {
  await page.click("text=Stop the run");
  assert.ok((await page.evaluate(() => window.asked)).includes("POST stop"));
});

test("a run that has ended has its page and no button", async (page) => {
  await answered(page, { ...run, life: "ended", status: undefined });
  assert.equal(await page.locator("text=Stop the run").isVisible(), false);
  assert.equal(await page.locator('a[href="page"]').isVisible(), true);
  assert.equal(await page.locator('[role="progressbar"]').getAttribute("aria-valuenow"), "100");
});

await runTests(process.argv[2], tests);
