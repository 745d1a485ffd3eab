// Opens the page of a run that grains come into and leave, whose states have unlike numbers of grains.
// Usage: node exchange_page.test.mjs PAGE.html
import assert from "node:assert/strict";
import { runTests, settle } from "./run.mjs";

const tests = [
  {
    name: "every state shows the grains that it has, and contacts that join these",
    run: async (page) => {
      const last = await page.evaluate(() => window.arenite.sample.snapshotCount - 1);
      assert.equal(last, 5);
      const counts = [];
      for (let k = 0; k <= last; ++k) {
        await page.evaluate((to) => window.arenite.state.set({ snapshot: to }), k);
        await settle(page);
        const seen = await page.evaluate(() => {
          const { view, sample } = window.arenite,
            { x, y, contacts } = view.snapshot;
          const gap = ([a, b]) => Math.hypot(x[a] - x[b], y[a] - y[b]) - sample.radius[a] - sample.radius[b];
          const pairs = [...contacts.i].map((i, c) => [i, contacts.j[c]]).filter(([, j]) => j < sample.count);
          const grains = [...x].filter((v) => !Number.isNaN(v)).length;
          return { grains, touch: pairs.every((pair) => gap(pair) < 1e-6) };
        });
        counts.push(seen.grains);
        assert.ok(seen.touch, `a contact of state ${k} joins grains that are apart`);
      }
      assert.equal(counts[0], 60);
      assert.equal(counts.at(-1), counts.at(-2));
      assert.ok(counts[4] > 60 && counts.every((count) => count < 92), counts.join(" "));
    },
  },
];

await runTests(process.argv[2], tests);
