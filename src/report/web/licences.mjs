// The licence texts of the packages that ended up in a bundle.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

/** The packages that ended up in a bundle, by the paths of its inputs. */
function packagesOf(metafile) {
    const names = new Set();
    for (const [path, input] of Object.entries(metafile.inputs)) {
        const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path);
        if (match && input) names.add(match[1]);
    }
    return [...names].sort();
}

/** Name, version and licence text of each package, equal texts once. @param {string} folder of node_modules */
export function licencesOf(folder, metafile) {
    const holders = new Map();
    for (const name of packagesOf(metafile)) {
        const place = join(folder, "node_modules", name);
        const { version, license } = JSON.parse(readFileSync(join(place, "package.json"), "utf8"));
        const file = readdirSync(place).find((entry) => /^licen[cs]e/i.test(entry));
        if (!file || !existsSync(join(place, file))) throw new Error(`${name} has no licence text`);
        const text = readFileSync(join(place, file), "utf8").replaceAll("\r\n", "\n").trim();
        holders.set(text, [...(holders.get(text) ?? []), `${name} ${version} (${license})`]);
    }
    const parts = [...holders].map(([text, who]) => `${who.join(", ")}\n\n${text}\n`);
    return parts.join(`\n${"-".repeat(72)}\n\n`);
}
