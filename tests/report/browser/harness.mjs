// What the tests of the page share: counting checks, opening pages, looking at pictures.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { pathToFileURL } from "node:url";

export const plan = JSON.parse(readFileSync(process.argv[2], "utf8"));
const require = createRequire(`${plan.packages}/`);
const { chromium } = require("playwright-core");
export const AXE = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
let passed = 0;
let failed = 0;

export function check(what, holds, detail = "") {
    if (holds) ++passed;
    else {
        ++failed;
        console.log(`FAIL ${what}${detail === "" ? "" : `: ${typeof detail === "string" ? detail : JSON.stringify(detail)}`}`);
    }
}

export function verdict() {
    console.log(`${passed} passed, ${failed} failed`);
    return failed === 0 && passed > 0 ? 0 : 1;
}

/** It writes nothing at home. */
const env = { ...process.env, XDG_CONFIG_HOME: tmpdir(), XDG_CACHE_HOME: tmpdir() };
export const launch = () => chromium.launch({ executablePath: plan.browser, args: ARGUMENTS, env });

/** [ms] after which what is waited for never comes; no result depends on it. */
const PATIENCE = 900_000;

/** Waits until something holds on a page. (Playwright's own way needs `eval`, which the page forbids.) */
export async function until(page, holds) {
    for (const end = Date.now() + PATIENCE; Date.now() < end;) {
        if (await page.evaluate(holds)) return;
        await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`waited in vain for ${holds}`);
}

/**
 * Opens a page and notes what must not happen on it: messages on the console, requests, errors.
 * @returns {Promise<{page: object, complaints: string[]}>}
 */
export async function open(browser, file, { width = 1280, height = 900, dark = false, hash = "", before } = {}) {
    const page = await browser.newPage({ viewport: { width, height }, colorScheme: dark ? "dark" : "light", acceptDownloads: true });
    const complaints = [];
    page.on("console", (message) => {
        if (["error", "warning"].includes(message.type()) && !/GPU stall|Automatic fallback to software/.test(message.text())) {
            complaints.push(`console: ${message.text()}`);
        }
    });
    page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
    page.on("request", (request) => {
        if (request.url().replace(/#.*/, "") !== pathToFileURL(file).href && !/^(blob|data):/.test(request.url())) complaints.push(`request: ${request.url().slice(0, 100)}`);
    });
    if (before) await page.addInitScript(before);
    await page.goto(pathToFileURL(file).href + hash);
    await page.waitForSelector("html[data-ready]", { timeout: PATIENCE });
    await until(page, () => [...document.querySelectorAll("main > section .drawing")].every((place) => place.offsetWidth === 0 || place.querySelector("svg")));
    return { page, complaints };
}

/** Reads pictures in the page, which has what is needed to decode them. */
function pixels(page, pictures, look) {
    return page.evaluate(async ([addresses, source]) => {
        const data = [];
        for (const address of addresses) {
            const image = new Image();
            image.src = address;
            await image.decode();
            const canvas = document.createElement("canvas");
            canvas.width = image.width;
            canvas.height = image.height;
            const pen = canvas.getContext("2d");
            pen.drawImage(image, 0, 0);
            data.push(pen.getImageData(0, 0, canvas.width, canvas.height).data);
        }
        return source === "colours" ? new Set(data[0].filter((_, place) => place % 4 === 0).map((red) => red >> 3)).size
            : data[0].reduce((count, value, place) => count + (Math.abs(value - data[1][place]) > 40), 0) / data[0].length;
    }, [pictures.map((picture) => `data:image/png;base64,${picture.toString("base64")}`), look]);
}

/** How many shades of red a picture has, of 32. A blank one has one. */
export const coloursOf = (page, picture) => pixels(page, [picture], "colours");

/** Whether two pictures differ by more than the smoothing of edges. */
export async function differ(page, one, other) {
    return (await pixels(page, [one, other], "difference")) > 2e-4;
}

/** A picture of an element, once two in a row are the same: nothing is being drawn any more. */
export async function settled(locator) {
    let before = await locator.screenshot();
    for (let tries = 0; tries < 40; ++tries) {
        await new Promise((resolve) => setTimeout(resolve, 150));
        const now = await locator.screenshot();
        if (now.equals(before)) return now;
        before = now;
    }
    return before;
}

/** A settled picture of an element that differs from an earlier one: what an action does is drawn some time later. */
export const changed = (page, locator, earlier) => settledWhen(locator, (picture) => differ(page, picture, earlier));

/** A settled picture of an element that is as an earlier one again. */
export const restored = (page, locator, earlier) => settledWhen(locator, async (picture) => !(await differ(page, picture, earlier)));

/** The last picture is returned if what is waited for does not come. */
async function settledWhen(locator, holds) {
    let picture = await settled(locator);
    for (let tries = 0; tries < 20 && !(await holds(picture)); ++tries) picture = await settled(locator);
    return picture;
}

/** Serious and critical findings of axe-core. */
export async function accessibility(page) {
    await page.evaluate(AXE);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
    return violations.filter((entry) => ["serious", "critical"].includes(entry.impact))
        .map((entry) => `${entry.id}: ${entry.nodes.slice(0, 3).map((node) => `${node.target} (${node.failureSummary?.split("\n")[1]?.trim()})`).join("; ")}`);
}
