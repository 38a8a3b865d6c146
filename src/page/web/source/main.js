// Starts the page: unpacks the engine, opens what the address holds or the first scene.
import { element } from "../../../report/web/source/dom.js";
import { themeSwitch } from "../../../report/web/source/theme.js";
import { Client } from "./client.js";
import { deckOf } from "./link.js";
import { Page } from "./page.js";
import { word } from "./words.js";

/** What is inside of the page: unpacked for who asks. */
function licences() {
    const text = element("pre", { tabindex: 0 });
    const part = element("details", {}, element("summary", {}, word("licences")), text);
    part.addEventListener("toggle", async () => {
        if (text.textContent === "") text.textContent = new TextDecoder().decode(await globalThis.ljmdPart("licences"));
    });
    return part;
}

async function begin() {
    const root = document.getElementById("page");
    const client = new Client(new TextDecoder().decode(await globalThis.ljmdPart("worker")), await globalThis.ljmdPart("engine"));
    const version = await client.ready;
    const page = new Page(client, version);
    const isPart = /(^#|&)view=atoms(&|$)/.test(location.hash);
    document.documentElement.classList.toggle("part", isPart);
    root.replaceChildren(element("a", { class: "skip", href: "#content" }, word("skip")),
        element("header", {}, element("div", { class: "bar" }, element("span", { class: "brand" }, "ljmd"), element("span", { class: "grow" }), themeSwitch())),
        page.node, element("footer", {}, element("p", {}, word("foot", { version: version.version })), licences()));
    let linked = null;
    let complaint = null;
    try {
        linked = await deckOf(location.hash);
    } catch (error) {
        complaint = error.message;
    }
    if (linked) {
        page.texts.deck.value = linked.deck;
        page.ofText = async () => { await page.open(linked.deck, { name: linked.name }); page.readControls(); };
        await page.guard(page.ofText);
        page.ofText = () => page.openText();
    } else {
        await page.guard(() => page.openScene("liquid"));
        if (complaint) page.texts.complain(complaint);
    }
    globalThis.ljmdPage = page;     // for who looks inside: tests, and the curious
    document.documentElement.dataset.ready = "true";
}

begin().catch((error) => {
    document.getElementById("page").replaceChildren(element("main", {}, element("p", { class: "why" }, word("broken", { why: error.message }))));
    throw error;
});
