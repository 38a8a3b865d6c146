// Prints pages to PDF, for run_browser_tests.py to measure their sheets; nothing is wider than a sheet.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { assemble } from "../../../src/report/web/assemble.mjs";
import { check, launch, open, plan, verdict } from "./harness.mjs";
import * as studies from "./studies.mjs";

/** [pixels] between the margins of A4, the narrower of the two. */
const SHEET = Math.floor(((210 - 24) / 25.4) * 96);

const payloads = Object.fromEntries(plan.pages.map((entry) => [entry.name, JSON.parse(readFileSync(entry.payload, "utf8"))]));
for (const kind of ["reproduction", "comparison"]) payloads[kind] = studies[kind]("text");
const browser = await launch();
for (const [name, payload] of Object.entries(payloads)) {
    const file = join(plan.folder, `${name}.html`);
    writeFileSync(file, assemble(payload));
    const { page, complaints } = await open(browser, file, { dark: true });
    for (const format of ["A4", "Letter"]) await page.pdf({ path: join(plan.folder, `${name}-${format}.pdf`), format });
    await page.setViewportSize({ width: SHEET, height: 900 });
    await page.emulateMedia({ media: "print" });
    await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
    const widths = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    check(`${name}: nothing is wider than a sheet`, widths[0] <= widths[1], widths);
    const over = await page.evaluate(() => [...document.querySelectorAll("main .drawing svg")].filter((svg) =>
        svg.getBoundingClientRect().right > svg.closest(".chart").getBoundingClientRect().right + 1).length);
    check(`${name}: charts are within their columns`, over === 0, over);
    check(`${name}: no complaint and no request`, complaints.length === 0, complaints.join(" | "));
    await page.close();
}
await browser.close();
process.exit(verdict());
