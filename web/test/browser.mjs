import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

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
  const profile = mkdtempSync(join(tmpdir(), "arenite-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: executable(),
    args: flags,
    acceptDownloads: true,
    ...options,
  });
  try {
    return await use(context);
  } finally {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
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

/** Reads painted pixels: takes a screenshot and gives a function from a place on the page to [r, g, b]. */
export async function painted(page) {
  const png = (await page.screenshot()).toString("base64");
  const { width, pixels } = await page.evaluate(async (base64) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(image.width, image.height),
      context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const url = await new Promise((done) => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result);
      reader.readAsDataURL(new Blob([data]));
    });
    return { width: image.width, pixels: url.slice(url.indexOf(",") + 1) };
  }, png);
  const bytes = Buffer.from(pixels, "base64"); // all at once: a question to the page for each pixel takes far longer
  return (x, y) => {
    const at = 4 * (Math.round(y) * width + Math.round(x));
    return [...bytes.subarray(at, at + 3)];
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
