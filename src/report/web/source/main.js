// Makes the page from the payload that stands in it.
import { element } from "./dom.js";
import { reportSections } from "./page/report.js";
import { pageHead } from "./page/verdict.js";
import { themeSwitch } from "./theme.js";

const VERSION = 1;

function navigation(sections) {
    return element("nav", { "aria-label": "Sections" }, element("ul", {}, sections.map((part) => {
        const heading = part.querySelector("h2");
        return element("li", {}, element("a", { href: `#${heading.id}` }, heading.textContent));
    })));
}

function page(payload) {
    document.title = `${payload.title || payload.source || "report"} · ljmd`;
    const theme = themeSwitch();
    const sections = reportSections(payload);
    document.getElementById("page").append(
        element("a", { class: "skip", href: "#content" }, "Skip to the content"),
        element("header", {}, element("div", { class: "bar" }, element("span", { class: "brand" }, "ljmd"), navigation(sections), theme)),
        element("main", { id: "content", tabindex: -1 }, pageHead(payload), sections),
        element("footer", {}, element("p", {}, "Made by ", element("code", {}, "ljmd report"),
            ". This file needs no network; it can be sent and archived as it is. Charts by Observable Plot, atoms by three.js; their licences are in the source of this page.")));
}

function failure(error) {
    document.getElementById("page").replaceChildren(element("main", {}, element("h1", {}, "This report cannot be shown"),
        element("p", { class: "why" }, error.message)));
    throw error;
}

try {
    const payload = JSON.parse(document.getElementById("ljmd-data").textContent);
    if (payload.format !== "ljmd-report") throw new Error("The data in this page are not those of a report.");
    if (payload.version > VERSION) throw new Error(`The data have version ${payload.version}; this page knows version ${VERSION}.`);
    page(payload);
    // While it is written anew. A browser comes back to where the reader was.
    if (payload.reload) setTimeout(() => location.reload(), 1000 * payload.reload);
    document.documentElement.dataset.ready = "true";
} catch (error) {
    failure(error);
}
