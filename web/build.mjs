// Builds a page's template: one HTML text with script and styles inside. Usage: node build.mjs OUTPUT [page|study]
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { build } from "esbuild";

const output = process.argv[2] ?? "dist/page.html";
const slot = (type, id, mark) => `<script type="application/${type}" id="${id}">${mark}</script>`;
const { entry, data } = {
  page: {
    entry: "src/main.js",
    data: [slot("octet-stream", "document", "__DOCUMENT__"), slot("octet-stream", "numbers", "__NUMBERS__")],
  },
  study: { entry: "src/study/main.js", data: [slot("json", "figures", "__FIGURES__")] },
}[process.argv[3] ?? "page"];

async function bundle(entry) {
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    charset: "ascii",
    metafile: true,
    format: "iife",
    target: ["chrome100", "firefox113", "safari16.4"],
    legalComments: "none",
  });
  return { text: result.outputFiles[0].text.trim(), inputs: Object.keys(result.metafile.inputs) };
}

// The licences of what is inside ask for their notice in every copy.
function notices(inputs) {
  const folders = new Set(inputs.map((path) => path.match(/node_modules\/(@[^/]+\/[^/]+|[^/]+)/)?.[0]).filter(Boolean));
  return [...folders]
    .sort()
    .map((folder) => {
      const { name, version, license } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
      const text = ["LICENSE", "LICENSE.md", "LICENSE.txt"]
        .map((file) => {
          try {
            return readFileSync(`${folder}/${file}`, "utf8");
          } catch {
            return "";
          }
        })
        .join("\n");
      const holder = text.match(/Copyright[^\n]*/)?.[0].trim() ?? "";
      return `  ${name} ${version} (${license}) ${holder}`;
    })
    .join("\n")
    .replace(/[^\x20-\x7e\n]/g, "");
}

const script = await bundle(entry);
const style = await bundle("src/style.css");
const place = (text, mark, value) => text.split(mark).join(value);
let html = readFileSync("src/page.html", "utf8");
html = place(html, "__DATA__", data.join("\n"));
html = place(html, "__NOTICES__", notices(script.inputs));
html = place(html, "__STYLE__", style.text);
html = place(html, "__SCRIPT__", script.text);
mkdirSync(dirname(output), { recursive: true });
writeFileSync(output, html);
