// Makes a page from a payload: what the program does in C++, for tests of the page alone.
//
//     node assemble.mjs PAYLOAD.json PAGE.html
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const dist = new URL("dist/", import.meta.url);
const read = (name) => readFileSync(new URL(name, dist), "utf8");

/** The page that shows a payload. A function as replacement keeps `$` as it is. */
export function assemble(payload) {
    const data = JSON.stringify(payload)
        .replaceAll("<", "\\u003c")
        .replaceAll("\u2028", "\\u2028")
        .replaceAll("\u2029", "\\u2029");
    const parts = { css: read("report.css"), data, js: read("report.js") };
    return read("index.html").replace(/\/\*ljmd:(\w+)\*\//g, (_, name) => parts[name]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const [input, output] = process.argv.slice(2);
    writeFileSync(output, assemble(JSON.parse(readFileSync(input, "utf8"))));
}
