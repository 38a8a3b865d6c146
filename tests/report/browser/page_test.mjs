// Pages of `ljmd report` in Chromium; run_browser_tests.py makes them and calls this with a plan.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { assemble } from "../../../src/report/web/assemble.mjs";
import { checkCharts, checkDownloads, checkNumbers, checkTables, checkTexts } from "./content_checks.mjs";
import { checkAccess, checkKeyboard, checkNarrow, checkPrint, checkTheme } from "./form_checks.mjs";
import { check, coloursOf, launch, open, plan, settled, verdict } from "./harness.mjs";
import * as studies from "./studies.mjs";
import { checkAtoms, checkLink, checkViewer } from "./viewer_checks.mjs";

const browser = await launch();

async function visit(name, file, options, look) {
    const { page, complaints } = await open(browser, file, options);
    try {
        await look(page);
    } catch (error) {
        check(`${name}: ${error.message}`, false);
    }
    check(`${name}: no complaint and no request`, complaints.length === 0, complaints.join(" | "));
    await page.close();
}

function made(name, payload) {
    const file = join(plan.folder, `${name}.html`);
    writeFileSync(file, assemble(payload));
    return file;
}

const noWebGl = () => {
    const context = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : context.call(this, kind, ...rest);
    };
};

const pages = Object.fromEntries(plan.pages.map((entry) => [entry.name, { ...entry, payload: JSON.parse(readFileSync(entry.payload, "utf8")) }]));
const { fluid, bodies, both } = pages;

async function seenInShort() {
    await visit("fluid", fluid.page, {}, async (page) => {
        await checkTexts("fluid", page, fluid.payload);
        await checkNumbers("fluid", page, fluid.payload, fluid.results);
        await checkCharts("fluid", page, fluid.payload.charts);
        await checkAccess("fluid", page);
        await checkKeyboard("fluid", page);
        await checkViewer("fluid", page);
        await checkAtoms("fluid", page, fluid.payload.atoms);
        await checkLink("fluid", page);
        await checkTheme("fluid", page, false);
        await checkDownloads("fluid", page, fluid.payload);
        await checkTables("fluid", page, fluid.payload);
    });
    await visit("fluid, narrow", fluid.page, { width: 400, height: 800 }, async (page) => {
        await checkNarrow("fluid, narrow", page);
        await checkAccess("fluid, narrow", page);
    });
}

async function seenInLong() {
    await visit("fluid, dark", fluid.page, { dark: true }, async (page) => {
        await checkAccess("fluid, dark", page);
        await checkTheme("fluid, dark", page, true);
        await checkPrint("fluid, dark", page, true);
    });
    await visit("fluid without WebGL", fluid.page, { before: noWebGl }, async (page) => {
        check("without WebGL: says why", (await page.locator(".viewer .why").textContent()).includes("WebGL"));
        check("without WebGL: a still picture", (await coloursOf(page, await settled(page.locator(".stage")))) > 8);
        await checkAccess("fluid without WebGL", page);
    });
    await visit("bodies", bodies.page, {}, async (page) => {
        await checkTexts("bodies", page, bodies.payload);
        await checkViewer("bodies", page);
        await checkLink("bodies", page);
        await checkAccess("bodies", page);
        await checkPrint("bodies", page, true);
    });
    await visit("both", both.page, {}, async (page) => {
        await checkTexts("both", page, both.payload);
        check("both: a column for each run", (await page.locator("table.results thead th").count()) >= 3);
        const names = both.payload.members.map((member) => member.label);
        const keys = await page.locator("main > section > .charts > .chart .key").evaluateAll((nodes) => nodes.map((node) => [...node.children].map((entry) => entry.textContent.trim())));
        check("both: temperatures of both in one chart", keys.some((key) => JSON.stringify(key) === JSON.stringify(names)), [names, keys]);
        await page.locator("details", { has: page.locator(".member") }).first().locator("summary").first().click();
        await page.waitForSelector(".member .chart svg");
        check("both: a run unfolds", (await page.locator(".member .chart").count()) > 2);
        await checkAccess("both", page);
    });
    for (const kind of ["sweep", "reproduction", "comparison", "damaged"]) {
        const payload = studies[kind](plan.hostile);
        await visit(kind, made(kind, payload), { width: 400, height: 800 }, async (page) => {
            await checkTexts(kind, page, payload);
            if (kind !== "damaged") await checkCharts(kind, page, payload.charts);
            await checkNarrow(kind, page);
            await checkAccess(kind, page);
            if (kind === "reproduction") check("reproduction: the suspect row is marked", (await page.locator("tr.suspect").count()) === 1);
            if (kind === "sweep") check("sweep: failures come first", (await page.locator(".points li").first().getAttribute("class")) === "failed");
        });
    }
    await visit("dots", made("dots", studies.dots(plan.hostile)), {}, async (page) => {
        check("dots: only charts with more than a dot are put together", (await page.locator("main > section > .charts > .chart").count()) === 1);
    });
    const large = made("large", studies.large(plan.hostile));
    await visit("large", large, {}, async (page) => {
        const stage = page.locator(".stage");
        await stage.scrollIntoViewIfNeeded();
        check("large: the picture is not blank", (await coloursOf(page, await settled(stage))) > 8);
        check("large: at rest all atoms are drawn", (await page.locator(".stage canvas").getAttribute("data-drawn")) === "32000");
    });
    const foreign = made("foreign", { format: "something else" });
    const page = await browser.newPage();
    await page.goto(`file://${foreign}`);
    check("foreign: says what is wrong", (await page.locator("main").textContent()).includes("not those of a report"));
}

await seenInShort();
if (!plan.short) await seenInLong();
await browser.close();
process.exit(verdict());
