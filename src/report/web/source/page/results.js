// The results with their errors: the leading ones large, all of them in a table.
import { element, scroller, section } from "../dom.js";
import { number, pretty, withError, withSubscripts } from "../format.js";

/** A value as text: what the program wrote, else value and error rounded alike. */
export function valueText(quantity) {
    return quantity.text ? pretty(quantity.text) : withError(quantity.value, quantity.error);
}

function siText(quantity) {
    if (quantity.si_text) return pretty(quantity.si_text);
    return quantity.si_value === null || quantity.si_value === undefined ? "" : withError(quantity.si_value, quantity.si_error);
}

const unit = (text) => text && text !== "1" && element("span", { class: "unit" }, withSubscripts(text));
const words = (name) => String(name ?? "").replaceAll("_", " ");

// What a reader looks for first, where the payload does not say.
const FIRST = ["temperature", "potential_energy", "pressure", "density", "diffusion", "viscosity"];

function leading(quantities) {
    const asked = quantities.filter((entry) => entry.lead);
    if (asked.length > 0) return asked;
    const place = (entry) => (FIRST.includes(entry.name) ? FIRST.indexOf(entry.name) : FIRST.length);
    return quantities.filter((entry) => entry.error > 0).sort((a, b) => place(a) - place(b)).slice(0, 4);
}

/** The value large, its error smaller, and no line break within either. */
function largeValue(quantity) {
    const [value, error] = valueText(quantity).split(" ± ");
    return element("span", { class: "value" }, element("span", {}, value), error ? element("span", { class: "error" }, ` ± ${error}`) : null,
        quantity.mark ? element("sup", {}, quantity.mark) : null);
}

function card(quantity) {
    const si = siText(quantity);
    return element("li", {},
        element("span", { class: "name" }, words(quantity.name),
            quantity.symbol && element("i", {}, " ", withSubscripts(quantity.symbol))),
        largeValue(quantity),
        element("span", { class: "below" }, unit(quantity.unit), si && unit(quantity.unit) && " · ",
            si && element("span", {}, si, " ", unit(quantity.si_unit))));
}

/** What is known from elsewhere, and how far away the run is in units of both errors together. */
function reference(quantity) {
    const entry = quantity.reference;
    if (!entry) return null;
    const apart = (quantity.value - entry.value) / Math.hypot(quantity.error ?? NaN, entry.error ?? 0);
    return element("span", {}, entry.text ? pretty(entry.text) : withError(entry.value, entry.error),
        element("span", { class: "unit from" }, [entry.label, Number.isFinite(apart) ? `${number(apart, 2)} errors away` : null].filter(Boolean).join(", ")));
}

function row(quantity, has) {
    return element("tr", {},
        element("th", { scope: "row" }, words(quantity.name),
            quantity.symbol && element("i", {}, " ", withSubscripts(quantity.symbol))),
        element("td", {}, valueText(quantity), " ", unit(quantity.unit), quantity.mark && element("sup", {}, quantity.mark)),
        has.si && element("td", {}, siText(quantity), " ", siText(quantity) && unit(quantity.si_unit)),
        has.samples && element("td", {}, quantity.samples === undefined || quantity.samples === null ? "" : number(Math.round(quantity.samples))),
        has.reference && element("td", {}, reference(quantity)));
}

/** @returns {HTMLElement|null} null where nothing was measured */
export function resultsSection(payload, level) {
    const quantities = payload.quantities ?? [];
    if (quantities.length === 0) return null;
    const has = {
        si: quantities.some((entry) => siText(entry) !== ""),
        samples: quantities.some((entry) => entry.samples !== undefined && entry.samples !== null),
        reference: quantities.some((entry) => entry.reference),
    };
    const head = ["Quantity", payload.kind === "few-body" ? "Value, in the deck's units" : "Reduced units", has.si && "SI", has.samples && "Independent samples", has.reference && "Reference"];
    const table = element("table", { class: "results" },
        element("thead", {}, element("tr", {}, head.filter(Boolean).map((text) => element("th", { scope: "col" }, text)))),
        element("tbody", {}, quantities.map((entry) => row(entry, has))));
    const cards = leading(quantities);
    return section("Results", level,
        cards.length > 0 && element("ul", { class: "cards" }, cards.map(card)),
        scroller("Results", table),
        (payload.footnotes ?? []).length > 0 &&
            element("ul", { class: "footnotes" }, payload.footnotes.map((text) => element("li", {}, text))));
}
