// The page in Chromium: what it shows, that it asks for nothing, what a reader can do, and what hostile input comes to.
//
//     node page_test.mjs PLAN.json     {page, packages, browser, pictures, example, short}
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { AXE, check, launch, open, plan, until, verdict } from "../report/browser/harness.mjs";

const text = (page, selector) => page.evaluate((found) => document.querySelector(found)?.textContent ?? "", selector);
const step = (page) => page.evaluate(() => globalThis.ljmdPage.state?.step ?? 0);
/** Waits for the page to have done what it was asked for. */
const settled = (page) => page.evaluate(() => globalThis.ljmdPage.opening);
const scene = async (page, name) => {
    await page.click(`button.scene:text-is("${name}")`);
    await settled(page);
};
const picture = (page, name) => page.screenshot({ path: join(plan.pictures, `${name}.png`) });
const pause = async (page) => {
    await page.evaluate(() => globalThis.ljmdPage.transport.pause());
    await settled(page);
    // The last picture may still be under way; when two looks see the same step, none is.
    for (let before = -1, now = await step(page); before !== now; now = await step(page)) {
        before = now;
        await page.evaluate(() => globalThis.ljmdPage.client.call("version"));
        await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    }
};

async function firstMinute(page) {
    await until(page, () => globalThis.ljmdPage.state.step > 1400);
    await until(page, () => /±/.test(document.querySelector(".numbers td").textContent));
    check("the liquid has a temperature with an error", /^\d\.\d+ ± \d\.\d+$/.test(await text(page, ".numbers td")), await text(page, ".numbers td"));
    check("its state has a name", /^Liquid\./.test(await text(page, ".state-of-fluid")), await text(page, ".state-of-fluid"));
    await scene(page, "Melt");
    await until(page, () => globalThis.ljmdPage.known.rows.some((row) => row[globalThis.ljmdPage.known.place.order] < 0.1));
    check("a crystal at T = 1.9 has lost its order", true);
    await until(page, () => [...document.querySelectorAll(".numbers td")].filter((cell) => cell.textContent.includes("±")).length >= 3);
    await picture(page, "melt");
}

async function sliders(page) {
    await scene(page, "Liquid");
    await until(page, () => globalThis.ljmdPage.state.step > 30);
    const before = await step(page);
    await page.focus(".of-temperature input");
    await page.keyboard.press("ArrowRight");
    await settled(page);
    check("the deck follows a slider", /temperature = 0\.86/.test(await page.inputValue("textarea")), (await page.inputValue("textarea")).slice(0, 300));
    check("time goes on", /name = "stage-1"/.test(await page.inputValue("textarea")) && (await step(page)) >= before && before > 30, [before, await step(page)]);
    const times = await page.evaluate(() => globalThis.ljmdPage.known.rows.map((row) => row[globalThis.ljmdPage.known.place.step]));
    check("each sample stands once, in its order", times.every((each, place) => place === 0 || each > times[place - 1]), times.slice(0, 40));
    await page.evaluate(() => {
        const slider = document.querySelector(".of-density input");
        slider.value = "0.5";
        slider.dispatchEvent(new Event("input"));
    });
    await settled(page);
    check("a torn liquid is called so", /not stable|two phases|metastable/i.test(await text(page, ".state-of-fluid")), await text(page, ".state-of-fluid"));
    await page.evaluate(() => document.querySelector(".of-density input").dispatchEvent(new Event("change")));
    await settled(page);
    check("with another density the atoms go on from where they were", /start\.xyz/.test(await page.inputValue("textarea")));
    check("the box has the density of the slider", Math.abs((await page.evaluate(() => globalThis.ljmdPage.run.density)) - 0.5) < 1e-6);
    await page.selectOption(".of-size select", "4");
    await settled(page);
    check("another number of atoms is another run", (await page.evaluate(() => globalThis.ljmdPage.run.atoms)) === 256);
}

async function time(page) {
    await scene(page, "Reverse time");
    await page.evaluate(() => { globalThis.ljmdPage.transport.pace.value = 7; globalThis.ljmdPage.transport.setPace(); });
    await until(page, () => !document.querySelector(".verdict-line").hidden);
    check("the end is the last step", /3000 \/ 3000|3 000 \/ 3 000/.test((await text(page, ".controls .time")).replaceAll("\u202f", " ")), await text(page, ".controls .time"));
    check("time runs back to the last bit", /to the last bit/.test(await text(page, ".verdict-line")), await text(page, ".verdict-line"));
    await page.click('button:text-is("From the start")');
    await settled(page);
    await until(page, () => globalThis.ljmdPage.state.step > 100);
    await pause(page);
    await page.click('button:text-is("Turn time round")');
    await settled(page);
    await until(page, () => !document.querySelector(".verdict-line").hidden);
    check("it runs back from where it is turned", /to the last bit/.test(await text(page, ".verdict-line")), await text(page, ".verdict-line"));
    await page.check(".controls .check input");     // which begins again
    await settled(page);
    await until(page, () => !document.querySelector(".verdict-line").hidden);
    check("with one flipped bit it does not", /not back/.test(await text(page, ".verdict-line")), await text(page, ".verdict-line"));
    await page.uncheck(".controls .check input");
    await settled(page);
}

async function blowUp(page) {
    const deck = (await page.evaluate(() => globalThis.ljmdPage.texts.deck.value));
    await page.fill("textarea", deck.replaceAll(/time_step = [\d.]+/g, "time_step = 0.2"));
    await page.check(".texts .check input");
    await page.click('button:text-is("Run this deck")');
    await settled(page);
    await until(page, () => !document.querySelector(".trouble").hidden);
    check("a blow-up is told with its step, and explained", /step/.test(await text(page, ".trouble pre")) && /time step that is too long/.test(await text(page, ".trouble")), await text(page, ".trouble"));
    await page.uncheck(".texts .check input");
}

async function texts(page) {
    await scene(page, "Crystal");
    const before = await page.evaluate(() => globalThis.ljmdPage.run.serial);
    await page.fill("textarea", (await page.inputValue("textarea")).replace("density", "densty"));
    await page.click('button:text-is("Run this deck")');
    await settled(page);
    check("a mistake has the program's message", (await text(page, ".messages")).startsWith("error: page.toml:5:1: unknown key 'densty' in [system]") &&
        (await text(page, ".messages")).includes("did you mean 'density'?"), await text(page, ".messages"));
    check("what ran before is still there", (await page.evaluate(() => globalThis.ljmdPage.run.serial)) === before);
    const reached = await step(page);
    await until(page, () => globalThis.ljmdPage.state.step > 10 && globalThis.ljmdPage.transport.playing);
    check("and goes on", reached >= 0);
    await scene(page, "Crystal");
    await until(page, () => globalThis.ljmdPage.state.step > 50);
    await pause(page);
    await until(page, () => /^xxh3:/.test(document.querySelector(".checksum").textContent));
    const home = { deck: await page.inputValue("textarea"), command: await text(page, "section[aria-labelledby=home] code"), checksum: await text(page, ".checksum") };
    writeFileSync(join(plan.pictures, "home.json"), JSON.stringify(home));
    check("the command at home names the steps", /^ljmd run page\.toml --set stage\.equilibration\.steps=\d+/.test(home.command), home.command);
    await page.click('button:text-is("Copy a link to this deck")');
    await settled(page);
    const link = page.url();
    check("a link holds the deck", /#deck=[\w-]+$/.test(link) && link.length < 3000, link.length);
    await page.click('button:text-is("Check the digits")');
    await settled(page);
    check("the digits are right", /^All digits are those/.test(await text(page, "section[aria-labelledby=home] p[role=status]")));
    return link;
}

/** What a reader does faster than the engine: the last wish counts, and nothing of an earlier run is left. */
async function impatience(page) {
    for (const name of ["Melt", "Comet", "Film", "Reverse time", "Liquid"]) await page.click(`button.scene:text-is("${name}")`);
    await settled(page);
    await until(page, () => globalThis.ljmdPage.state.step > 100);
    check("of many scenes the last is shown", (await page.evaluate(() => globalThis.ljmdPage.run.atoms)) === 864);
    check("its deck has its own title", /^title = "864 atoms/.test(await page.inputValue("textarea")), (await page.inputValue("textarea")).slice(0, 60));
    await pause(page);
    await until(page, () => /^xxh3:/.test(document.querySelector(".checksum").textContent));
    const told = await page.evaluate(async () => {
        await globalThis.ljmdPage.look();
        const { step, checksum } = await globalThis.ljmdPage.client.call("checksum");
        return { step, checksum, shown: globalThis.ljmdPage.state.step, words: document.querySelector(".checksum").textContent };
    });
    check("the checksum is that of the step that is shown", told.step === told.shown && told.checksum === told.words, told);
}

async function exercises(page) {
    await scene(page, "Liquid");
    await until(page, () => globalThis.ljmdPage.state.step > 2500);
    await pause(page);
    await page.evaluate(() => globalThis.ljmdPage.look());
    const wanted = await page.evaluate(() => Math.sqrt(2 * globalThis.ljmdPage.known.results.observables.temperature.mean));
    for (const [given, words] of [[String(wanted.toFixed(2)), /^Right/], [String((1.4 * wanted).toFixed(2)), /lower/], ["", /Type a number/]]) {
        await page.fill(".exercise input", given);
        await page.click(".exercise button");
        check(`the answer '${given}' is judged`, words.test(await text(page, ".exercise p")), await text(page, ".exercise p"));
    }
}

async function fewBodies(page) {
    for (const name of ["Comet", "Pendulum", "Figure eight", "Pythagorean"]) {
        await scene(page, name);
        await until(page, () => globalThis.ljmdPage.state.step > 10 && document.querySelector(".picture canvas"));
        check(`${name}: sliders of fluids are gone`, !(await page.isVisible(".side")));
    }
    await picture(page, "bodies");
}

async function accessible(page, name) {
    await page.evaluate(AXE);
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    check(`axe has nothing against ${name}`, violations.length === 0, violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 120)}`));
}

async function hostile(browser, link) {
    const good = new URL(link).hash;
    const cases = [
        ["a damaged link", "#deck=%%%%", /damaged/], ["a link that ends early", good.slice(0, good.length / 2), /damaged/], ["a link of a megabyte", `#deck=${"A".repeat(1_000_000)}`, /longer than a link/],
    ];
    for (const [what, hash, words] of cases) {
        const { page, complaints } = await open(browser, plan.page, { hash });
        check(`${what} gets one message, and the page works`, words.test(await text(page, ".messages")) && (await page.evaluate(() => globalThis.ljmdPage.run.atoms)) === 864, await text(page, ".messages"));
        check(`${what}: no complaint`, complaints.length === 0, complaints);
        await page.close();
    }
    const { page, complaints } = await open(browser, plan.page);
    const deck = await page.inputValue("textarea");
    for (const [what, changed, words] of [
        ["1e9 atoms", deck.replace(/cells = \d+/, "cells = 630").replace(/\[analysis\][^]*/, ""), /200000|memory/], ["no TOML", "<script>window.broken = 1</script>", /not valid TOML/],
        ["markup in a title", deck.replace(/title = ".*"/, 'title = "<img src=x onerror=window.broken=1>"').replace("density = 0.8442", "density = -1"), /density/],
        ["half a megabyte", `title = "${"x".repeat(500_000)}"`, /error/], ["another file", deck.replace(/lattice = .*\n/, 'file = "/etc/passwd"\n'), /passwd/],
    ]) {
        await page.fill("textarea", changed);
        await page.click('button:text-is("Run this deck")');
        await settled(page);
        check(`${what} gets one message`, words.test(await text(page, ".messages")), (await text(page, ".messages")).slice(0, 200));
    }
    check("nothing of it was run", !(await page.evaluate(() => globalThis.broken)));
    check("no complaint about hostile decks", complaints.length === 0, complaints);
    await page.close();
}

async function looks(browser) {
    for (const [name, size] of [["light", {}], ["dark", { dark: true }], ["narrow", { width: 400, height: 800 }], ["projector", { width: 1280, height: 720 }]]) {
        const { page, complaints } = await open(browser, plan.page, size);
        await until(page, () => globalThis.ljmdPage.state.step > 200);
        check(`${name}: nothing is wider than the page`, await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
        await picture(page, name);
        await pause(page);
        await accessible(page, name);
        check(`${name}: no complaint`, complaints.length === 0, complaints);
        await page.close();
    }
    const { page } = await open(browser, plan.page, { hash: "#view=atoms" });
    check("in a slide there is the picture alone", (await page.isVisible(".stage")) && !(await page.isVisible(".side")) && !(await page.isVisible("header")));
    await page.close();
}

/** Somebody else's page with the engine as a module. Modules come from a server, so here is one. */
async function moduleExample(browser) {
    const files = new Map([["/", [plan.example, "text/html"]], ["/ljmd.mjs", [plan.page.replace(/ljmd\.html$/, "ljmd.mjs"), "text/javascript"]]]);
    const server = createServer((request, response) => {
        const [file, type] = files.get(request.url) ?? [];
        response.writeHead(file ? 200 : 404, { "Content-Type": type ?? "text/plain" });
        response.end(file ? readFileSync(file) : "");
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const page = await browser.newPage();
    page.on("pageerror", (error) => check("the example of the module has no error", false, error.message));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await until(page, () => /^U = /.test(document.getElementById("words").textContent));
    const words = await text(page, "#words");
    check("the example of the module ends with an energy, its error and a checksum", /^U = -\d\.\d{3} ± 0\.\d{3}, xxh3:/.test(words), words);
    writeFileSync(join(plan.pictures, "example.json"), JSON.stringify({ checksum: words.split(", ")[1] }));
    await picture(page, "example");
    await page.close();
    server.close();
}

const browser = await launch();
const { page, complaints } = await open(browser, plan.page);
await firstMinute(page);
if (!plan.short) {
    await sliders(page);
    await time(page);
    await blowUp(page);
    await impatience(page);
    await exercises(page);
}
await fewBodies(page);
const link = await texts(page);
check("no complaint, no request", complaints.length === 0, complaints);
await page.close();
const { page: linked } = await open(browser, plan.page, { hash: new URL(link).hash });
check("the link opens the deck", (await linked.inputValue("textarea")) === JSON.parse(readFileSync(join(plan.pictures, "home.json"), "utf8")).deck);
await linked.close();
await moduleExample(browser);
if (!plan.short) {
    await hostile(browser, link);
    await looks(browser);
}
await browser.close();
process.exit(verdict());
