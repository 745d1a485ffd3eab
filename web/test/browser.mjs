import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { chromium } from "playwright-core";
import bundle from "playwright-core/lib/utilsBundle";

const flags = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

function executable() {
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch {
      /* the next one */
    }
  }
  throw new Error("No Chromium was found: install Debian's package chromium.");
}

/** Runs `use` with a context of a fresh profile; software rendering, so that it needs no graphics card. */
export async function withBrowser(options, use) {
  const browser = await chromium.launch({ executablePath: executable(), args: flags });
  try {
    return await use(await browser.newContext({ acceptDownloads: true, ...options }));
  } finally {
    await browser.close();
  }
}

/** Runs `use` with another context of the page's browser, which shares nothing with the page: to start a browser takes
    longer than to open a page. */
export async function besideIt(page, options, use) {
  const context = await page.context().browser().newContext({ acceptDownloads: true, ...options });
  try {
    return await use(context);
  } finally {
    await context.close();
  }
}

/** What the page must never do: speak of errors, or ask anybody for anything. */
export function watch(page) {
  const seen = { errors: [], requests: [] };
  page.on("console", (message) => {
    if (message.type() === "error") seen.errors.push(message.text());
  });
  page.on("pageerror", (error) => seen.errors.push(error.stack));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) seen.requests.push(request.url());
  });
  return seen;
}

export const pause = 400; // ms: longer than a view in space waits until it is at rest

/** The same page in a context of its own, on which nothing may go wrong. */
export async function elsewhere(page, options, prepare, then) {
  await besideIt(page, options, async (context) => {
    const other = await context.newPage(),
      { errors } = watch(other);
    if (prepare) await other.addInitScript(prepare);
    await other.goto(page.url().split("#")[0]);
    await other.waitForSelector("html[data-ready]");
    await other.waitForTimeout(pause);
    await then(other);
    assert.deepEqual(errors, []);
  });
}

/** Reads painted pixels: takes a screenshot and gives a function from a place on the page to [r, g, b]. */
export async function painted(page) {
  // Decoded here: pixels that a page has decoded take three times as long to come from it.
  const { width, data } = bundle.PNG.sync.read(await page.screenshot());
  return (x, y) => {
    const at = 4 * (Math.round(y) * width + Math.round(x));
    return [...data.subarray(at, at + 3)];
  };
}

/** Clicks and returns the bytes of the file that is saved. Headless Chromium loses about one download of a blob in
    sixty without a word, so a click may be repeated. */
export async function saved(page, selector) {
  for (let attempt = 1; ; ++attempt) {
    try {
      const [download] = await Promise.all([page.waitForEvent("download", { timeout: 5000 }), page.click(selector)]);
      return readFileSync(await download.path());
    } catch (error) {
      if (attempt === 3) throw error;
    }
  }
}

export const difference = (a, b) => Math.max(...a.map((v, k) => Math.abs(v - b[k])));
