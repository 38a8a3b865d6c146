// The points of a sweep or a reproduction: how each ended, and the way to its own report.
import { element, section } from "../dom.js";
import { pretty } from "../format.js";

/** A relative address whatever the text is: no scheme and no host can come out of it. */
export function relativeAddress(path) {
    const parts = String(path).split("/").filter((part) => part !== "" && part !== ".");
    return `./${parts.map((part) => (part === ".." ? ".." : encodeURIComponent(part))).join("/")}`;
}

function item(point) {
    const label = element("bdi", {}, pretty(point.label));
    return element("li", { class: /^[a-z]+$/.test(point.state ?? "") ? point.state : null },
        point.href ? element("a", { href: relativeAddress(point.href) }, label) : label,
        point.state ? element("span", { class: "state" }, point.state) : null,
        point.words ? element("p", {}, pretty(point.words)) : null,
        point.directory && !point.href ? element("code", {}, element("bdi", {}, point.directory)) : null);
}

/** Those that failed first: they are what a reader has to know. A reference has runs in place of points. */
export function pointsSection(points, level, title = "Points") {
    if (points.length === 0) return null;
    const bad = points.filter((point) => point.state && point.state !== "finished");
    const good = points.filter((point) => !bad.includes(point));
    return section(title, level,
        bad.length > 0 ? [element(`h${level + 1}`, {}, `${bad.length} of ${points.length} did not finish`), element("ul", { class: "points" }, bad.map(item))] : null,
        good.length > 0 ? element("details", { open: good.length <= 12 }, element("summary", {}, `${good.length} finished`), element("ul", { class: "points" }, good.map(item))) : null);
}
