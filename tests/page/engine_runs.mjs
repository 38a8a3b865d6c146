// Runs decks with the compiled engine of the page, in node: a plan in, answers out, both JSON.
//
//     node engine_runs.mjs ENGINE PLAN.json ANSWERS.json     ENGINE: folder of ljmd_page.js and ljmd_page.wasm
//
// A plan is a list of {name, deck, settings, files}. An answer is {configuration, checksum} of the end of the run, {error, kind}, or
// {opened} where the plan's entry has `open_only`.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { makeEngine } from "../../src/page/web/source/engine.js";

const [folder, plan, out] = process.argv.slice(2);
const factory = createRequire(import.meta.url)(resolve(folder, "ljmd_page.js"));
const wasm = readFileSync(join(folder, "ljmd_page.wasm"));
const engine = await makeEngine(factory, wasm);

const answers = [];
for (const { name, deck, settings = [], files = {}, open_only: openOnly = false } of JSON.parse(readFileSync(plan, "utf8"))) {
    try {
        const { warnings } = engine.call({ call: "open", name, deck, settings, files, force: false });
        if (openOnly) {
            answers.push({ opened: true, warnings });
            continue;
        }
        // In pieces, as the page does.
        for (let state = engine.call({ call: "advance", steps: 0 }); !state.finished;) state = engine.call({ call: "advance", steps: 37 });
        answers.push({ configuration: engine.call({ call: "configuration" }), checksum: engine.call({ call: "checksum" }).checksum });
    } catch (error) {
        if (error.kind === undefined) throw error;
        answers.push({ error: error.message, kind: error.kind });
    }
}
const digits = engine.call({ call: "verify" });
writeFileSync(out, JSON.stringify({ answers, digits }));
