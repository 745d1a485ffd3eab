// Opens the page of a biaxial test as `arenite run` wrote it, from its packing to its end.
// Usage: node run_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { runTests, settle } from "./run.mjs";

const state = (page, key) => page.evaluate((name) => window.arenite.state.get(name), key);

const tests = [
  {
    name: "what was tested comes first, with its loads",
    run: async (page) => {
      assert.match(await page.locator(".tile").first().innerText(), /^(critical state|peak) q\/p/);
      const figures = page.locator(".figures > [data-figure]"),
        order = await figures.evaluateAll((all) => all.map((figure) => figure.dataset.figure));
      assert.equal(order[0], "test-curves");
      assert.ok(order.indexOf("fabric") > 0);
      const loads = (await page.locator(".loads table").innerText()).split("\n").map((row) => row.trim());
      assert.match(loads.join(" "), /prescribed, kPa\s+reached, kPa/);
      assert.match(loads.at(-1), /^right\s+50\.0/);
    },
  },
  {
    name: "the picture holds the grains of every state, and is filled by them",
    run: async (page) => {
      const last = await page.evaluate(() => window.arenite.sample.snapshotCount - 1);
      for (let k = 0; k <= last; ++k) {
        await page.evaluate((to) => window.arenite.state.set({ snapshot: to }), k);
        await settle(page);
        const { width, height, box } = await page.evaluate(() => {
          const { view, sample } = window.arenite,
            { camera, snapshot } = view,
            ends = [...sample.radius].flatMap((r, g) =>
              [-1, 1].map((sign) => camera.toScreen(snapshot.x[g] + sign * r, snapshot.y[g] + sign * r)),
            );
          const of = (axis) => ends.map((end) => end[axis]);
          return {
            width: camera.width,
            height: camera.height,
            box: [Math.min(...of(0)), Math.max(...of(0)), Math.min(...of(1)), Math.max(...of(1))],
          };
        });
        assert.ok(box[0] >= 0 && box[1] <= width && box[2] >= 0 && box[3] <= height, `state ${k}: ${box}`);
        const filled = Math.max((box[1] - box[0]) / width, (box[3] - box[2]) / height);
        assert.ok(k < last || filled > 0.6, `state ${k} fills ${filled} of ${width} by ${height}`);
      }
    },
  },
  {
    name: "a click on a curve of the test shows the state next to it",
    run: async (page) => {
      const drawing = page.locator('[data-figure="test-curves"] .drawing');
      await drawing.scrollIntoViewIfNeeded();
      await settle(page);
      const box = await drawing.boundingBox(),
        last = await state(page, "snapshot");
      await page.mouse.click(box.x + 56, box.y + box.height / 2);
      await settle(page);
      const first = await page.evaluate(() => {
        const { snapshots } = window.arenite.sample.about;
        return snapshots.findIndex(({ stage }) => stage === snapshots.at(-1).stage);
      });
      assert.ok(last > first);
      assert.equal(await state(page, "snapshot"), first);
    },
  },
];

await runTests(process.argv[2], tests);
