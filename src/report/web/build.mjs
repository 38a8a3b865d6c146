// Bundles the page: source/ and style/ into dist/, which is committed, and stays readable. Needs `npm ci`.
//
//     node build.mjs [FOLDER]      FOLDER: instead of dist/, as the test does that compares with what is committed
import { build } from "esbuild";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { join } from "node:path";

const here = fileURLToPath(new URL(".", import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

const bundle = {
    absWorkingDir: here,
    bundle: true,
    charset: "utf8",
    legalComments: "none",
    target: ["es2020"],
    write: false,
    metafile: true,
};

/** The packages that ended up in a bundle, by the paths of its inputs. */
function packagesOf(metafile) {
    const names = new Set();
    for (const [path, input] of Object.entries(metafile.inputs)) {
        const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path);
        if (match && input) names.add(match[1]);
    }
    return [...names].sort();
}

/** Name, version and licence text of each package, equal texts once. */
function licences(names) {
    const holders = new Map();
    for (const name of names) {
        const folder = join(here, "node_modules", name);
        const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
        const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
        if (!file || !existsSync(join(folder, file))) throw new Error(`${name} has no licence text`);
        const text = readFileSync(join(folder, file), "utf8").replaceAll("\r\n", "\n").trim();
        holders.set(text, [...(holders.get(text) ?? []), `${name} ${version} (${license})`]);
    }
    const parts = [...holders].map(([text, who]) => `${who.join(", ")}\n\n${text}\n`);
    return `The page of ljmd report contains these packages:\n\n${parts.join(`\n${"-".repeat(72)}\n\n`)}`;
}

const script = await build({ ...bundle, entryPoints: ["source/main.js"], format: "iife" });
const style = await build({ ...bundle, entryPoints: ["style/report.css"] });
const texts = licences(packagesOf(script.metafile));

// The page is handed on as one file, so the licences travel in its script.
const code = `/*!\n${texts.replaceAll("*/", "* /")}*/\n${script.outputFiles[0].text}`;
if (/<\/script|<!--/i.test(code)) throw new Error("the bundle would end the script element that it stands in");

mkdirSync(out, { recursive: true });
writeFileSync(join(out, "report.js"), code);
writeFileSync(join(out, "report.css"), style.outputFiles[0].text);
writeFileSync(join(out, "THIRD-PARTY-LICENSES"), texts);
copyFileSync(join(here, "index.html"), join(out, "index.html"));
