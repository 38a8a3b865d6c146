// Bundles the page: source/ and style/ into dist/, which is committed, and stays readable. Needs `npm ci`.
//
//     node build.mjs [FOLDER]      FOLDER: instead of dist/, as the test does that compares with what is committed
import { build } from "esbuild";
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { join } from "node:path";
import { licencesOf } from "./licences.mjs";

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

const script = await build({ ...bundle, entryPoints: ["source/main.js"], format: "iife" });
const style = await build({ ...bundle, entryPoints: ["style/report.css"] });
const texts = `The page of ljmd report contains these packages:\n\n${licencesOf(here, script.metafile)}`;

// The page is handed on as one file, so the licences travel in its script.
const code = `/*!\n${texts.replaceAll("*/", "* /")}*/\n${script.outputFiles[0].text}`;
if (/<\/script|<!--/i.test(code)) throw new Error("the bundle would end the script element that it stands in");

mkdirSync(out, { recursive: true });
writeFileSync(join(out, "report.js"), code);
writeFileSync(join(out, "report.css"), style.outputFiles[0].text);
writeFileSync(join(out, "THIRD-PARTY-LICENSES"), texts);
copyFileSync(join(here, "index.html"), join(out, "index.html"));
