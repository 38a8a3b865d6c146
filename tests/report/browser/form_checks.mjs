// How a page is shown: dark, narrow, printed, by keyboard, to a screen reader.
import { accessibility, check, coloursOf } from "./harness.mjs";

const brightness = (page) => page.evaluate(() => {
    const [red, green, blue] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return (red + green + blue) / 3;
});

export async function checkAccess(name, page) {
    const findings = await accessibility(page);
    check(`${name}: axe-core finds nothing serious`, findings.length === 0, findings.join(" | "));
}

/** @param {boolean} dark what the system asks for */
export async function checkTheme(name, page, dark) {
    check(`${name}: colours as the system says`, (await brightness(page)) < 60 === dark, await brightness(page));
    const button = page.getByRole("button", { name: "Dark colours" });
    await button.click();
    check(`${name}: the switch changes them`, (await brightness(page)) < 60 !== dark, await brightness(page));
    check(`${name}: the switch says so`, (await button.getAttribute("aria-pressed")) === String(!dark));
    await button.click();
}

export async function checkNarrow(name, page) {
    const widths = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    check(`${name}: nothing is wider than 400 pixels`, widths[0] <= widths[1], widths);
}

/** On paper: light colours whatever the screen shows, no buttons, the atoms as a still picture. */
export async function checkPrint(name, page, hasViewer) {
    const pdf = await page.pdf({ printBackground: false });
    check(`${name}: PDF`, pdf.subarray(0, 5).toString() === "%PDF-" && pdf.length > 20000, pdf.length);
    await page.emulateMedia({ media: "print" });
    await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
    check(`${name}: paper is white`, (await brightness(page)) > 250, await brightness(page));
    check(`${name}: no buttons on paper`, (await page.locator("button:visible").count()) === 0, await page.locator("button:visible").allTextContents());
    const ink = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--ink").trim());
    check(`${name}: dark ink on paper`, ink === "#1a1d21", ink);
    if (hasViewer) {
        const still = page.locator("canvas.print-only").first();
        check(`${name}: a still picture on paper`, (await still.isVisible()) && (await coloursOf(page, await still.screenshot())) > 8);
    }
    await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
    await page.emulateMedia({ media: null });
}

/** Tab reaches everything, beginning with the way past the navigation; what has the focus can be seen. */
export async function checkKeyboard(name, page) {
    await page.evaluate(() => { document.activeElement?.blur(); window.scrollTo(0, 0); });
    const reached = [];
    for (let presses = 0; presses < 60; ++presses) {
        await page.keyboard.press("Tab");
        reached.push(await page.evaluate(() => {
            const node = document.activeElement;
            const style = getComputedStyle(node);
            return { what: `${node.tagName.toLowerCase()}.${node.className}`, ring: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0 };
        }));
    }
    const kinds = new Set(reached.map((entry) => entry.what));
    check(`${name}: Tab begins with the skip link`, reached[0].what === "a.skip", reached[0]);
    for (const kind of ["button.theme", "div.stage", "button.play"]) check(`${name}: Tab reaches ${kind}`, kinds.has(kind), [...kinds].join(" "));
    const unseen = reached.filter((entry) => !entry.ring && entry.what !== "body.");
    check(`${name}: the focus is seen`, unseen.length === 0, unseen);
}
