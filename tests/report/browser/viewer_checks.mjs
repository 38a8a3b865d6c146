// The viewers: something is drawn, it plays, it turns, an atom can be picked; by mouse and by keyboard.
import { changed, check, coloursOf, differ, restored, settled, until } from "./harness.mjs";

const frameOf = (page) => page.locator(".stage canvas").first().evaluate((canvas) => Number(canvas.dataset.frame));

export async function checkViewer(name, page) {
    const stage = page.locator(".stage").first();
    await stage.scrollIntoViewIfNeeded();
    const first = await settled(stage);
    check(`${name}: the picture is not blank`, (await coloursOf(page, first)) > 8, await coloursOf(page, first));

    await page.locator("button.play").first().click();
    await until(page, () => Number(document.querySelector(".stage canvas").dataset.frame) > 0);
    await page.locator("button.play").first().click();
    const played = await changed(page, stage, first);
    const frame = await frameOf(page);
    check(`${name}: playing goes on`, frame > 0, frame);
    check(`${name}: playing moves what is drawn`, await differ(page, played, first));
    check(`${name}: pausing stops`, (await page.locator("button.play").first().getAttribute("aria-label")) === "Play");

    const slider = page.locator('.playback input[type="range"]').first();
    await slider.focus();
    await page.keyboard.press("Home");
    const back = await restored(page, stage, first);
    check(`${name}: the slider goes back by key`, (await frameOf(page)) === 0);
    check(`${name}: the first frame looks as before`, !(await differ(page, back, first)));
    await page.keyboard.press("ArrowRight");
    check(`${name}: the slider says where it is`, /frame 2 of \d+, t = /.test(await slider.getAttribute("aria-valuetext")), await slider.getAttribute("aria-valuetext"));
    await page.keyboard.press("Home");

    await stage.focus();
    await page.keyboard.press("ArrowRight");
    const turned = await changed(page, stage, first);
    check(`${name}: arrow keys turn`, await differ(page, turned, first));
    await page.keyboard.press("+");
    check(`${name}: plus zooms`, await differ(page, await changed(page, stage, turned), turned));
    await page.keyboard.press("0");
    await stage.evaluate((node) => node.blur());
    check(`${name}: 0 resets`, !(await differ(page, await restored(page, stage, first), first)));
    const { x, y, width, height } = await stage.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    check(`${name}: the mouse turns`, await differ(page, await changed(page, stage, first), first));
    await page.locator(".viewer button", { hasText: "Reset view" }).first().click();
    return first;
}

/** @param {object} atoms of the payload */
export async function checkAtoms(name, page, atoms) {
    const stage = page.locator(".stage").first();
    const first = await settled(stage);
    const { x, y, width, height } = await stage.boundingBox();
    await page.mouse.click(x + width / 2, y + height / 2);
    const said = await page.locator(".picked").textContent();
    check(`${name}: a click picks an atom`, /^Atom \d+ {2}· {2}/.test(said), said);
    check(`${name}: the picked atom is marked`, await differ(page, await changed(page, stage, first), first));
    await page.locator(".controls input[type=number]").fill("7");
    await page.keyboard.press("Enter");
    const words = await page.locator(".picked").textContent();
    const speed = atoms.colours.find((colour) => colour.name === "speed");
    const value = speed.low + (Buffer.from(speed.values, "base64")[7] / 255) * (speed.high - speed.low);
    check(`${name}: an atom by its number, with its speed`, words.startsWith("Atom 7") && Math.abs(Number(words.split("  ·  ")[1].split(" ").at(-1)) - value) <= 0.006 * value, [words, value]);
    const marked = await settled(stage);
    await page.getByLabel("Trace").check();
    check(`${name}: its way is drawn`, await differ(page, await changed(page, stage, marked), marked));
    await page.getByLabel("Trace").uncheck();
    await page.getByLabel("Box").uncheck();
    check(`${name}: the box can be left out`, await differ(page, await changed(page, stage, marked), marked));
    const choice = page.getByLabel("Colour", { exact: true });
    check(`${name}: colours`, JSON.stringify(await choice.locator("option").evaluateAll((options) => options.map((option) => option.value))) === JSON.stringify([...atoms.colours.map((colour) => colour.name), "id"]));
    const uncoloured = await settled(stage);
    await choice.selectOption("id");
    check(`${name}: another colour`, await differ(page, await changed(page, stage, uncoloured), uncoloured));
    check(`${name}: says how many frames there are`, (await page.locator(".viewer .caption").textContent()).includes(`${atoms.shown_frames} frames`));
}

/** A chart over the time has a line that follows the playback, and a click on it moves the playback. */
export async function checkLink(name, page) {
    const cursor = page.locator(".chart .cursor").first();
    const slider = page.locator('.playback input[type="range"]').first();
    await slider.focus();
    await page.keyboard.press("End");
    const end = Number(await cursor.getAttribute("x1"));
    const drawing = page.locator(".chart", { has: page.locator(".cursor") }).first().locator(".drawing svg");
    await drawing.scrollIntoViewIfNeeded();
    const { width, height } = await drawing.boundingBox();
    await drawing.click({ position: { x: width / 2, y: height / 2 } });
    const middle = Number(await cursor.getAttribute("x1"));
    const frame = Number(await slider.inputValue());
    const last = Number(await slider.getAttribute("max"));
    check(`${name}: the line follows`, middle > 60 && middle < end, [middle, end]);
    check(`${name}: a click on the chart moves the playback`, frame > 0 && frame < last, [frame, last]);
}
