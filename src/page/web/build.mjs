// Puts the page together: script and Worker by esbuild, the compiled engine, decks of few bodies, the lines of the phase
// diagram, which the engine computes once; all packed into one file.
//
//     node build.mjs ENGINE FOLDER      ENGINE: folder of ljmd_page.js, ljmd_page.wasm and LICENCES of what they contain
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";

const [engine, out] = process.argv.slice(2);
const here = fileURLToPath(new URL(".", import.meta.url));
const report = join(here, "../../report/web");
const { build } = createRequire(`${report}/`)("esbuild");
const { licencesOf } = await import(join(report, "licences.mjs"));

const options = { absWorkingDir: here, bundle: true, minify: true, charset: "utf8", legalComments: "none", target: ["es2022"], write: false, metafile: true, nodePaths: [join(report, "node_modules")] };
const fewBodies = join(here, "../../../inputs/fewbody");
const decks = Object.fromEntries(readdirSync(fewBodies).filter((name) => name.endsWith(".toml"))
    .map((name) => [name.replace(".toml", ""), readFileSync(join(fewBodies, name), "utf8")]));

const glue = readFileSync(join(engine, "ljmd_page.js"), "utf8");
const wasm = readFileSync(join(engine, "ljmd_page.wasm"));
const { makeEngine } = await import("./source/engine.js");
const computed = await makeEngine(createRequire(import.meta.url)(resolve(engine, "ljmd_page.js")), wasm);
const diagram = computed.call({ call: "diagram" });

const script = await build({ ...options, entryPoints: ["source/main.js"], format: "iife", define: { ljmdFewBodies: JSON.stringify(decks), ljmdDiagram: JSON.stringify(diagram) } });
const worker = await build({ ...options, entryPoints: ["source/worker.js"], format: "iife" });
const style = await build({ ...options, entryPoints: ["style/page.css"] });

const licences = `This page contains ljmd itself (GPL-3.0-or-later) and what follows.

In its script:

${licencesOf(report, script.metafile)}
In its engine:

${readFileSync(join(engine, "LICENCES"), "utf8")}`;

const packed = (content) => deflateRawSync(content, { level: 9 }).toString("base64");
const parts = {
    css: style.outputFiles[0].text,
    engine: packed(wasm),
    worker: packed(`${glue}\nglobalThis.ljmdEngine = ljmdEngine;\n${worker.outputFiles[0].text}`),
    script: packed(script.outputFiles[0].text),
    licences: packed(licences),
};
const page = readFileSync(join(here, "index.html"), "utf8")
    .replace(/\/\*ljmd:(\w+)\*\//g, (_, name) => parts[name]);
writeFileSync(join(out, "ljmd.html"), page);

const module = await build({ ...options, entryPoints: ["source/module.js"], format: "esm" });
writeFileSync(join(out, "ljmd.mjs"), `/* ljmd, GPL-3.0-or-later; licences of what else is inside: the page ljmd.html shows them. */\n${glue}\nconst ljmdPacked = "${parts.engine}";\n${module.outputFiles[0].text}`);
writeFileSync(join(out, "ljmd.d.ts"), readFileSync(join(here, "ljmd.d.ts")));
for (const name of ["ljmd.html", "ljmd.mjs"]) console.log(`${name}: ${Math.round(readFileSync(join(out, name)).length / 1024)} KiB`);
