import assert from "node:assert/strict";
import { test } from "node:test";
import { readDrawn } from "../src/drawn.js";
import { frameOf } from "../src/space/frame.js";
import { seenCell } from "../src/volume/ray.js";
import { VolumeResult } from "../src/volume/result.js";
import { filling } from "../src/volume/scene.js";
import { units } from "./program.mjs";

readDrawn({ units });

test("a line of sight meets the first voxel that is seen, whatever is cut away", () => {
  const size = [4, 5, 6],
    all = () => true;
  const along = (azimuth, elevation, point, kept = size, isSeen = all) =>
    seenCell(frameOf(azimuth, elevation), point, size, kept, isSeen);
  // From above: x to the right of a viewer whose azimuth is -90 degrees, y upwards.
  assert.deepEqual(along(-90, 90, [-1.5, 2]), [0, 4, 5]);
  assert.deepEqual(along(-90, 90, [-1.5, 2], [4, 5, 3]), [0, 4, 2]);
  assert.equal(along(-90, 90, [2.1, 0]), null);
  // From x, with y to the right and z upwards, through what is not seen.
  assert.deepEqual(along(0, 0, [-2, 2.5]), [3, 0, 5]);
  assert.deepEqual(
    along(0, 0, [-2, 2.5], size, ([x]) => x < 2),
    [1, 0, 5],
  );
  assert.equal(
    along(0, 0, [-2, 2.5], size, () => false),
    null,
  );
  // A cube's corner is seen in its middle from (1, 1, 1), and cut off there is seen what lay behind.
  const corner = (kept) =>
    seenCell(frameOf(45, (Math.atan(Math.SQRT1_2) * 180) / Math.PI), [0, 0.01], [3, 3, 3], kept, all);
  assert.deepEqual(corner([3, 3, 3]), [2, 2, 2]);
  assert.deepEqual(corner([2, 2, 2]), [1, 1, 1]);
});

test("codes of a volume are values again, in order, and said to lie beyond where they end", () => {
  const code = [0, 1, 128, 255],
    about = {
      name: "tension",
      size: [4, 1, 1],
      dx: 1e-3,
      stride: 1,
      phase: { at: 0, n: 4, as: "u1" },
      quantities: {
        zz: { unit: "Pa", low: 0, high: 254, least: -5, most: 254, mean: 127, code: { at: 4, n: 4, as: "u1" } },
      },
      numbers: {},
    };
  const result = new VolumeResult(about, new Uint8Array([0, 1, 2, 2, ...code]), "");
  assert.deepEqual(
    [1, 2, 3].map((voxel) => result.written("zz", voxel)),
    ["\u2264\u20090", "127\u202fPa", "254\u202fPa"].map((words, k) => (k ? words : `${words}\u202fPa`)),
  );
  const order = [...result.order("zz")];
  assert.equal(order.length, 3);
  order.forEach((value, k) => assert.ok(Math.abs(value - [0, 127, 254][k]) <= 0.5, `${value}`));
  assert.deepEqual(result.voxelAt([3, 0, 0]), 3);
  assert.equal(result.voxelAt([4, 0, 0]), null);
  assert.equal(result.lengths([result.place(0), result.place(3)]), "0.500, 3.50\u202fmm");
});

test("how much of a neighbourhood is seen is a mean over the neighbours of a voxel", () => {
  const one = new Uint8Array(27);
  one[13] = 255;
  const full = filling(one, [3, 3, 3]);
  // 255/8 in the middle, half of it beside, each rounded three times.
  assert.ok(Math.abs(full[13] - 255 / 8) <= 1.5, `${full[13]}`);
  assert.ok(Math.abs(full[14] - 255 / 16) <= 1.5, `${full[14]}`);
  assert.ok(filling(new Uint8Array(27).fill(255), [3, 3, 3]).every((share) => share === 255));
});
