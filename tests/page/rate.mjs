// Seconds that the page's engine takes for all steps of a deck, in node.
//
//     node rate.mjs ENGINE DECK
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { makeEngine } from "../../src/page/web/source/engine.js";

const [folder, deck] = process.argv.slice(2);
const factory = createRequire(import.meta.url)(resolve(folder, "ljmd_page.js"));
const engine = await makeEngine(factory, readFileSync(join(folder, "ljmd_page.wasm")));
const { steps } = engine.call({ call: "open", name: "deck.toml", deck: readFileSync(deck, "utf8"), settings: [], force: false });
engine.call({ call: "advance", steps: 0 });
const begin = performance.now();
// As the page does: some steps at a time.
for (let done = 0; done < steps; done += 20) engine.call({ call: "advance", steps: 20 });
console.log((performance.now() - begin) / 1000);
