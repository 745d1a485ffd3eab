// Opens a page from the disk and asserts what is painted. Usage: node page.test.mjs PAGE.html
import { runTests } from "./run.mjs";
import { tests as painting } from "./page/painting.mjs";
import { tests as pointer } from "./page/pointer.mjs";
import { tests as numbers } from "./page/numbers.mjs";

await runTests(process.argv[2], [...painting, ...pointer, ...numbers]);
