// All tests, one after another: links, answers, sizes, the page in Chromium. ASSUR names the program, ASSUR_WASM the module, FILTER a part
// of the names.

import { answers } from "./answers.mjs";
import { links } from "./links.mjs";
import { pages } from "./pages.mjs";
import { sizes } from "./sizes.mjs";
import { run } from "./run.mjs";

await import("../build.mjs");
await run({ ...links, ...sizes, ...answers, ...pages });
