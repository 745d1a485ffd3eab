// What the page of a film paints.
import assert from "node:assert/strict";
import { difference, painted } from "../browser.mjs";
import { rgb } from "../run.mjs";
import { show, tab, onPage, grains, contacts, brightness } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("every film has its tab, and the last one is open", async (page) => {
  assert.deepEqual(await page.locator(".tabs button").allInnerTexts(), ["Packing", "Maps", "Stresses", "Film"]);
  assert.match(await page.locator("header p").innerText(), /JADE III.*1\u202f480 frames at 148.*260 grains/);
  assert.match(
    await page.locator(".headlines:visible").innerText(),
    /load frequency[\s\S]*3\.00020 \u00b1 0\.00010\u202fHz[\s\S]*correlation with simulation/,
  );
});

test("the picture is bright where grains are warm, and its pixels come back in kelvin", async (page) => {
  await show(page, { map: "picture" });
  const picture = await painted(page),
    all = await grains(page);
  for (const material of [0, 1])
    for (const { x, y } of all.filter((g) => g.material === material).slice(0, 12)) {
      const place = await onPage(page, Math.round(x), Math.round(y)),
        shade = brightness(await picture(place.x, place.y));
      assert.ok(material ? shade > 200 : shade > 70 && shade < 190, `material ${material} is ${shade}`);
      const value = await page.evaluate(
        ([c, r]) => {
          const { film } = window.arenite.film;
          return film.values("picture")[c + film.width * r];
        },
        [Math.round(x), Math.round(y)],
      );
      assert.ok(Math.abs(value - (294.2 + (material ? 2.1 : 0.9))) < 0.1, `${value} K`);
    }
  const corner = await onPage(page, 1, 1);
  assert.ok(brightness(await picture(corner.x, corner.y)) < 60);
});

test("the signed amplitude is amber where the load warms and neutral outside", async (page) => {
  await show(page, { map: "in_phase" });
  const picture = await painted(page),
    strong = (await grains(page)).filter(({ norm }) => norm > 1.2);
  for (const { x, y } of strong.slice(0, 10)) {
    const place = await onPage(page, Math.round(x), Math.round(y)),
      [r, , b] = await picture(place.x, place.y);
    assert.ok(r > b + 30, `warm pixel is ${[r, b]}`);
  }
  const corner = await onPage(page, 2, 2);
  assert.ok(
    difference(await picture(corner.x, corner.y), rgb("#efeadc")) < 16,
    `outside is ${await picture(corner.x, corner.y)}`,
  );
});

test("a phase with the load has one colour, and what is lost in noise is pale", async (page) => {
  await show(page, { map: "phase" });
  const picture = await painted(page),
    strong = (await grains(page)).filter(({ norm }) => norm > 1);
  for (const { x, y } of strong.slice(0, 10)) {
    const place = await onPage(page, Math.round(x), Math.round(y));
    assert.ok(
      difference(await picture(place.x, place.y), rgb("#d98a1f")) < 25,
      `in phase is ${await picture(place.x, place.y)}`,
    );
  }
  let pale = 0;
  for (let k = 0; k < 20; ++k) {
    const place = await onPage(page, 4 + k, 2);
    pale += brightness(await picture(place.x, place.y)) > 195;
  }
  assert.ok(pale >= 18, `${pale} of 20 pixels without a grain are pale`);
  assert.equal(await page.locator('section.sample:visible [data-choice="law"]:visible').count(), 0);
});

test("bad pixels stand out in a colour of their own and are counted", async (page) => {
  await show(page, { map: "bad" });
  const picture = await painted(page);
  for (const column of [20, 21]) {
    const place = await onPage(page, column, 9);
    assert.ok(
      difference(await picture(place.x, place.y), rgb("#ff2d95")) <= 2,
      `bad pixel is ${await picture(place.x, place.y)}`,
    );
  }
  const good = await onPage(page, 22, 9);
  assert.ok(difference(await picture(good.x, good.y), rgb("#ff2d95")) > 60);
  assert.match(await page.locator(".field-key:visible").textContent(), /2 replaced/);
});

test("every map, law, clip and overlay paints its own picture", async (page) => {
  const seen = new Map(),
    shot = async (changes) => {
      await show(page, changes);
      const box = await page.locator("canvas.film:visible").boundingBox();
      seen.set(JSON.stringify(changes), (await page.screenshot({ clip: box })).toString("base64"));
    };
  for (const map of [
    "picture",
    "amplitude",
    "phase",
    "in_phase",
    "second_harmonic",
    "standard_error",
    "residual",
    "bad",
  ])
    await shot({ map });
  for (const changes of [
    { law: "symlog" },
    { clip: "5" },
    { clip: "all" },
    { grains: "rims" },
    { grains: "material" },
    { grains: "stress" },
    { forces: true },
    { motion: true },
  ])
    await shot(changes);
  assert.equal(
    new Set(seen.values()).size,
    seen.size,
    `${seen.size} states gave ${new Set(seen.values()).size} pictures`,
  );
});

test("rims lie on the grains' circles", async (page) => {
  const all = (await grains(page)).filter(({ material }) => material === 0).slice(20, 32);
  const shades = async () => {
    const picture = await painted(page),
      list = [];
    for (const { x, y, radius } of all) {
      const least = [];
      for (const step of [-1, -0.5, 0, 0.5, 1]) {
        const place = await onPage(page, x + radius * Math.cos(0.7), y + radius * Math.sin(0.7));
        least.push(brightness(await picture(place.x + step, place.y + step)));
      }
      list.push(Math.min(...least));
    }
    return list;
  };
  await show(page, { map: "standard_error", grains: "rims" });
  const rims = await shades();
  await show(page, { map: "standard_error", grains: "off" });
  (await shades()).forEach((shade, k) => assert.ok(rims[k] < shade - 30, `a rim is ${rims[k]} on ${shade}`));
});

test("disks are darker the more stress they carry", async (page) => {
  await show(page, { grains: "stress" });
  const picture = await painted(page),
    order = (await grains(page)).sort((a, b) => a.norm - b.norm),
    shades = [];
  for (const { x, y } of [order[5], order[Math.floor(order.length / 2)], order.at(-3)]) {
    const place = await onPage(page, x, y);
    shades.push(brightness(await picture(place.x, place.y)));
  }
  assert.ok(shades[0] > shades[1] + 15 && shades[1] > shades[2] + 15, `${shades}`);
  assert.match(await page.locator(".field-key:visible").textContent(), /\u03c3norm/);
});

test("forces are bars as thick as they are large, and what may be absent is dashed", async (page) => {
  await show(page, { forces: true });
  const all = await contacts(page),
    sure = all.filter(({ uncertain }) => !uncertain).sort((a, b) => b.fn - a.fn),
    picture = await painted(page);
  const [x1, y1, x2, y2] = sure[0].ends,
    middle = await onPage(page, (x1 + x2) / 2, (y1 + y2) / 2);
  assert.ok(
    difference(await picture(middle.x, middle.y), rgb("#14191f")) < 12,
    `bar is ${await picture(middle.x, middle.y)}`,
  );
  const { dashed, widths, wanted } = await page.evaluate(() => {
    const { view, film } = window.arenite.film,
      lines = [...view.lines.querySelectorAll("line")];
    const bars = lines.filter((l) => !l.hasAttribute("stroke-opacity") && !l.hasAttribute("stroke-dasharray"));
    return {
      dashed: lines.filter((l) => l.hasAttribute("stroke-dasharray")).length,
      widths: bars.map((l) => Number(l.getAttribute("stroke-width"))),
      wanted: Array.from(film.contacts.fn.keys()).filter((c) => film.isUncertain(c)).length,
    };
  });
  assert.ok(dashed === wanted && dashed > 20, `${dashed} dashed of ${wanted}`);
  const { fn, mean } = await page.evaluate(() => {
    const { film } = window.arenite.film;
    return {
      fn: Array.from(film.contacts.fn)
        .filter((_, c) => !film.isUncertain(c))
        .sort((a, b) => a - b),
      mean: film.meanForce,
    };
  });
  const per = widths[40] / fn[40];
  widths.forEach((w, k) => {
    if (fn[k] < 3 * mean) assert.ok(Math.abs(w - per * fn[k]) < 0.01 * w + 2e-3, `${w} for ${fn[k]} N`);
  });
});

test("a bar to a wall ends at the wall", async (page) => {
  const off = await page.evaluate(() => {
    const { film } = window.arenite.film,
      { i, j } = film.contacts,
      sides = film.container;
    return Array.from(i.keys())
      .filter((c) => j[c] >= film.count)
      .map((c) => {
        const [, , x, y] = film.endsOf(c),
          side = j[c] - film.count;
        return Math.abs((side < 2 ? x : y) - sides[side]);
      });
  });
  assert.ok(off.length > 20 && Math.max(...off) < 1, `${off.length} walls, off by up to ${Math.max(...off)} pixels`);
});
