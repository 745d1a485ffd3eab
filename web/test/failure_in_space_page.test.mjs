// Opens a page of a block in space that was pulled until it broke along a notch at mid-height, and asserts that its
// cracks are seen.
// Usage: node failure_in_space_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { runTests, settle } from "./run.mjs";

async function cracksLieAtMidHeight(page) {
  const seen = await page.evaluate(() => {
    const { view, result, state } = window.arenite.volume;
    state.set({ component: "damage" });
    state.set({ level: 6, surface: true });
    const [width, height, depth] = result.size,
      layers = new Set();
    for (let k = 0; k < width * height * depth; ++k) if (view.isSeen(k)) layers.add(Math.floor(k / (width * height)));
    return { layers: [...layers].sort((a, b) => a - b), depth, offered: result.offered };
  });
  assert.ok(seen.offered.includes("damage"));
  assert.ok(seen.layers.length > 0 && seen.layers.length < seen.depth / 2, String(seen.layers));
  const middle = seen.layers.reduce((sum, z) => sum + z, 0) / seen.layers.length;
  assert.ok(Math.abs(middle - (seen.depth - 1) / 2) < 2, String(seen.layers));
  await settle(page);
}

async function figuresOfTheTestAreThere(page) {
  for (const figure of ["stress-strain", "broken-bonds", "energy-balance"])
    assert.equal(await page.locator(`[data-figure="${figure}"]:visible .drawing`).count(), 1, figure);
}

await runTests(process.argv[2], [
  { name: "its cracks lie where it was notched", run: cracksLieAtMidHeight },
  { name: "the figures of the test are drawn", run: figuresOfTheTestAreThere },
]);
