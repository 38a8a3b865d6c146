// What a page says: the payload's numbers and texts, charts, tables, downloads.
import { readFileSync } from "node:fs";
import { check } from "./harness.mjs";

/** Text as the program writes it: plain minus signs, no narrow spaces, `+-`. */
const plain = (text) => text.replaceAll("−", "-").replaceAll("\u202f", "").replaceAll("±", "+-").replace(/\s+/g, " ").trim();

/** Text of the user's is shown as it is, and makes no element and runs nothing. */
export async function checkTexts(name, page, payload) {
    check(`${name}: title`, (await page.locator("h1").textContent()) === payload.title, await page.locator("h1").textContent());
    check(`${name}: title of the window`, (await page.title()).includes(payload.title.replace(/\s+/g, " ").trim()), await page.title());
    const broken = await page.evaluate(() => [window.broken, document.querySelectorAll("img, iframe, object").length, document.scripts.length]);
    check(`${name}: texts are no markup`, broken[0] === undefined && broken[1] === 0 && broken[2] === 2, broken);
    for (const entry of payload.verdict ?? []) {
        const items = (await page.locator(".verdict li").allTextContents()).map(plain);
        check(`${name}: verdict on ${entry.subject}`, items.some((text) => text.includes(plain(entry.subject))));
    }
    const links = await page.locator("main a[href]").evaluateAll((nodes) => nodes.map((node) => node.protocol));
    check(`${name}: links lead to files`, links.every((protocol) => protocol === "file:"), links);
}

/** Each quantity has its row with the program's digits, and results.json has the same number. */
export async function checkNumbers(name, page, payload, results) {
    const rows = await page.locator("table.results").first().locator("tbody tr").evaluateAll((nodes) => nodes.map((node) => [...node.cells].map((cell) => cell.textContent)));
    const cells = new Map(rows.map((row) => [row[0].split(" ").slice(0, 2).join(" "), row.map(plain)]));
    check(`${name}: a row for each quantity`, rows.length === payload.quantities.length, [rows.length, payload.quantities.length]);
    const observables = results ? JSON.parse(readFileSync(results, "utf8")).observables : {};
    payload.quantities.forEach((quantity, place) => {
        const row = rows[place].map(plain);
        check(`${name}: ${quantity.name} as in the payload`, row[1].startsWith(plain(quantity.text)), [row[1], quantity.text]);
        if (quantity.si_text) check(`${name}: ${quantity.name} in SI`, row[2].startsWith(plain(quantity.si_text)), [row[2], quantity.si_text]);
        const shown = Number(/^[-\d.e+]+/.exec(row[1])?.[0]);
        const mean = observables[quantity.name]?.mean;
        if (typeof mean === "number" && Number.isFinite(shown)) {
            check(`${name}: ${quantity.name} as in results.json`, Math.abs(shown - mean) <= (quantity.error || Math.abs(mean) * 1e-4), [shown, mean]);
        }
    });
    return cells.size;
}

/** Each chart is a labelled SVG with something drawn in it, and can be saved. */
export async function checkCharts(name, page, charts) {
    for (const [place, chart] of charts.entries()) {
        const figure = page.locator("main > section figure.chart", { has: page.locator("h3") }).nth(place);
        const found = await figure.evaluate((node) => {
            const svg = node.querySelector(".drawing svg");
            return { role: svg.getAttribute("role"), label: svg.getAttribute("aria-label"), title: node.querySelector("h3").textContent,
                marks: svg.querySelectorAll('g:not([aria-label*="axis"]):not([aria-label*="grid"]) > :is(path, circle, rect, line)').length };
        });
        check(`${name}: chart ${place} is an image with a name`, found.role === "img" && found.label === found.title, found);
        check(`${name}: chart ${place} has marks`, found.marks > 0, found);
    }
}

async function download(page, button) {
    const [file] = await Promise.all([page.waitForEvent("download"), button.click()]);
    return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

/** The CSV has each number of the table with all digits; the SVG stands alone. */
export async function checkDownloads(name, page, payload) {
    const files = page.locator("button.file");
    const table = payload.tables[0];
    const csv = await download(page, files.first());
    const lines = csv.text.trimEnd().split("\r\n");
    check(`${name}: head of the CSV`, lines[0] === table.columns.map((column) => column.name).join(","), lines[0]);
    check(`${name}: rows of the CSV`, lines.length === table.values[0].length + 1, lines.length);
    const numbers = table.values.every((values) => values.every((value) => typeof value === "number"));
    if (numbers) check(`${name}: last row of the CSV`, lines.at(-1) === table.values.map((values) => values.at(-1)).join(","), lines.at(-1));
    const chart = payload.charts.findIndex((entry) => entry.marks.some((mark) => mark.type === "line"));
    const svg = await download(page, files.nth(payload.tables.length + chart));
    const sound = await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror") === null, svg.text);
    check(`${name}: SVG is well formed`, sound && svg.text.startsWith("<svg") && svg.name.endsWith(".svg"), svg.name);
    check(`${name}: SVG has its colours inside`, !svg.text.includes("var(") && /stroke="#[0-9a-f]{6}"/.test(svg.text));
    check(`${name}: SVG has its title inside`, await page.evaluate(([text, title]) => new DOMParser().parseFromString(text, "image/svg+xml").documentElement.textContent.includes(title), [svg.text, payload.charts[chart].title]));
    check(`${name}: deck`, !payload.downloads.deck || (await page.locator("pre").allTextContents()).includes(payload.downloads.deck));
}

/** A table unfolds, and a click on a column sorts it. */
export async function checkTables(name, page, payload) {
    const details = page.locator("details.table").first();
    await details.locator("summary").click();
    const shown = () => details.locator("tbody tr td:first-child").allTextContents();
    const values = payload.tables[0].values[0];
    check(`${name}: rows of the table`, (await shown()).length === Math.min(values.length, 100), (await shown()).length);
    await details.locator("th button").first().click();
    await details.locator("th button").first().click();
    check(`${name}: sorted downwards`, Number(plain((await shown())[0])) === Math.max(...values), await shown());
    check(`${name}: says that it is sorted`, (await details.locator("th").first().getAttribute("aria-sort")) === "descending");
}
