import assert from "node:assert/strict";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { isDeepStrictEqual } from "node:util";
import { watch, withBrowser } from "./browser.mjs";
import { everyPage } from "./walk.mjs";

export const settle = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Asserts that `ask` comes to give these values, however long a busy machine takes to hear of a key. */
export async function becomes(ask, expected) {
  const end = performance.now() + 20000;
  while (performance.now() < end && !isDeepStrictEqual(await ask(), expected))
    await new Promise((done) => setTimeout(done, 50));
  assert.deepEqual(await ask(), expected);
}

/** Turns the wheel with Ctrl: zooms in by so many notches, each by half a power of two; out where they are negative. */
export async function zoom(page, notches) {
  await page.keyboard.down("Control");
  for (let k = 0; k < Math.abs(notches); ++k) await page.mouse.wheel(0, -100 * Math.sign(notches));
  await page.keyboard.up("Control");
  await settle(page);
}

/** Moves the pointer over a figure's drawing until one of its tips is shown, and gives its lines. */
export async function tipOf(page, figure) {
  const drawing = page.locator(`[data-figure="${figure}"]:visible .drawing`);
  await drawing.scrollIntoViewIfNeeded();
  const box = await drawing.boundingBox();
  for (const [x, y] of [
    [0.5, 0.5],
    [0.3, 0.3],
    [0.3, 0.7],
    [0.7, 0.5],
    [0.2, 0.2],
    [0.8, 0.3],
    [0.4, 0.8],
  ]) {
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await settle(page);
    const lines = await drawing
      .locator('[aria-label="tip"] text > tspan')
      .evaluateAll((all) => all.map((line) => line.textContent.replace("\u200b", "")));
    if (lines.length) return lines;
  }
  return [];
}

export const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));

/** Opens a page from the disk, runs its tests and those of every page on it one after the other, and leaves with their
    verdict; an error in the console or a request to anybody is a failure. */
export async function runTests(file, tests) {
  const failures = await withBrowser(
    { viewport: { width: 1400, height: 900 }, colorScheme: "light" },
    async (context) => {
      const page = await context.newPage(),
        seen = watch(page);
      page.setDefaultTimeout(20000);
      await page.goto(pathToFileURL(resolve(file)).href);
      await page.waitForSelector("html[data-ready]", { timeout: 60000 });
      await page.waitForTimeout(200);
      const failed = [];
      for (const { name, run } of [...tests, ...everyPage]) {
        const begin = performance.now();
        try {
          await run(page);
          console.log(`ok    ${name} (${((performance.now() - begin) / 1000).toFixed(1)} s)`);
        } catch (error) {
          failed.push(name);
          console.log(`FAIL  ${name}\n      ${error.message}`);
        }
      }
      if (seen.errors.length) failed.push(`errors in the console: ${[...new Set(seen.errors)].slice(0, 3).join("; ")}`);
      if (seen.requests.length) failed.push(`requests: ${seen.requests.join("; ")}`);
      return failed;
    },
  );
  if (failures.length === 0) return;
  console.log(`${failures.length} failed:\n  ${failures.join("\n  ")}`);
  process.exit(1);
}
