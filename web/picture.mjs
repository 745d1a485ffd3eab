// Paints the first screen of a page as a PNG, for the README: node picture.mjs PAGE.html PICTURE.png
// With pngquant on the machine the file becomes a third as large.
import { spawnSync } from "node:child_process";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { withBrowser } from "./test/browser.mjs";

const [page, picture] = process.argv.slice(2).map((path) => resolve(path));
await withBrowser({ viewport: { width: 1400, height: 900 }, colorScheme: "light" }, async (context) => {
  const tab = await context.newPage();
  await tab.goto(pathToFileURL(page).href);
  await tab.waitForSelector("html[data-ready]");
  await tab.waitForTimeout(1000);
  await tab.screenshot({ path: picture });
});
spawnSync("pngquant", ["--force", "--output", picture, "128", picture]);
