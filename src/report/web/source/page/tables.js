// Tables that can be sorted and saved. A long one shows its first rows; the file has all of them.
import { element, scroller, section } from "../dom.js";
import { number, pretty, withError, withSubscripts } from "../format.js";
import { fileName, saveButton } from "../save.js";
import { column, csv, rowCount } from "../tabular.js";

const FIRST_ROWS = 100;

/** Columns as they are shown: errors stand with their values, the flag marks rows. */
function shownColumns(table) {
    const errors = new Map(table.columns.filter((entry) => entry.error_of).map((entry) => [entry.error_of, entry.name]));
    return table.columns.filter((entry) => !entry.error_of && entry.name !== table.flag)
        .map((entry) => ({ ...entry, values: column(table, entry.name), errors: errors.has(entry.name) ? column(table, errors.get(entry.name)) : null }));
}

function cell(entry, row) {
    const value = entry.values[row];
    if (typeof value === "boolean") return value ? "yes" : "no";
    if (typeof value === "string") return element("bdi", {}, value);
    return entry.errors?.[row] > 0 ? withError(value, entry.errors[row]) : number(value);
}

function compare(a, b) {
    if (a === b) return 0;
    if (a === null || a === undefined) return 1;
    if (b === null || b === undefined) return -1;
    return typeof a === "string" ? a.localeCompare(String(b), "en", { numeric: true }) : a - b;
}

const columnHead = (entry, ...content) => element("th", { scope: "col", class: entry.values.some((value) => typeof value === "string") ? "text" : null }, content);
const nameOf = (entry) => [withSubscripts(entry.label || entry.name),
    entry.unit && entry.unit !== "1" ? element("span", { class: "unit" }, withSubscripts(entry.unit)) : null];

// About so many letters fit side by side on a sheet, and a column needs so many more.
const PAPER_LETTERS = 100;
const BETWEEN = 2;

function letters(entry) {
    const texts = entry.values.map((_, row) => cell(entry, row)).map((shown) => (typeof shown === "string" ? shown : shown.textContent));
    const words = [String(entry.label || entry.name), ...texts].flatMap((text) => text.split(/\s+/));
    return BETWEEN + Math.max(...words.map((word) => word.length), ...texts.map((text) => Math.min(24, text.length)));
}

/** Paper cannot be scrolled sideways: a table that is wider is printed in parts, which begin with the same columns. */
function paperParts(columns, hasFlags) {
    const measured = columns.findIndex((entry) => entry.errors);
    const names = columns.slice(0, Math.min(2, Math.max(1, measured)));
    const room = PAPER_LETTERS - (hasFlags ? 12 : 0) - names.reduce((sum, entry) => sum + letters(entry), 0);
    const parts = [];
    let left = -1;
    for (const entry of columns.slice(names.length)) {
        const needed = letters(entry);
        left -= needed;
        if (left < 0) {
            parts.push([...names]);
            left = room - needed;
        }
        parts.at(-1).push(entry);
    }
    return parts;
}

/** The grid alone, without heading. */
export function grid(table, label) {
    const columns = shownColumns(table);
    const flags = table.flag ? column(table, table.flag) : [];
    const order = Array.from({ length: rowCount(table) }, (_, row) => row);
    const body = element("tbody");
    const rows = (shown) => order.slice(0, table.lead ? order.length : FIRST_ROWS).map((row) =>
        element("tr", { class: flags[row] ? "suspect" : null }, shown.map((entry, place) => {
            const text = typeof entry.values[row] === "string";
            return element("td", { class: text ? "text" : null }, cell(entry, row),
                place === 0 && flags[row] ? element("span", { class: "flag" }, "suspect") : null);
        })));
    const fill = () => body.replaceChildren(...rows(columns));
    const heads = columns.map((entry) => {
        const head = columnHead(entry);
        const button = element("button", { type: "button", class: "sort" }, nameOf(entry));
        button.addEventListener("click", () => {
            const down = head.getAttribute("aria-sort") === "ascending";
            heads.forEach((other) => other.removeAttribute("aria-sort"));
            head.setAttribute("aria-sort", down ? "descending" : "ascending");
            order.sort((a, b) => (down ? -1 : 1) * compare(entry.values[a], entry.values[b]) || a - b);
            fill();
        });
        head.append(button);
        return head;
    });
    fill();
    const whole = element("table", {}, element("thead", {}, element("tr", {}, heads)), body);
    const region = scroller(label, whole);
    window.addEventListener("beforeprint", () => {
        const parts = paperParts(columns, Boolean(table.flag));
        if (parts.length < 2) return;
        region.replaceChildren(...parts.map((shown) => element("table", {},
            element("thead", {}, element("tr", {}, shown.map((entry) => columnHead(entry, nameOf(entry))))),
            element("tbody", {}, rows(shown)))));
    });
    window.addEventListener("afterprint", () => region.replaceChildren(whole));
    return region;
}

function rowWords(table) {
    const there = rowCount(table);
    const all = Math.max(table.rows ?? there, there);
    const shown = table.lead ? there : Math.min(there, FIRST_ROWS);
    const parts = [`${number(all)} rows`];
    if (there < all) parts.push(`${number(there)} of them are in this page${table.file ? `, all in ${table.file}` : ""}`);
    if (shown < there) parts.push(`the first ${shown} are shown`);
    return parts.join("; ");
}

/** A table that folds away; filled when it is opened. */
export function foldedTable(table) {
    const title = table.title || table.name;
    const content = element("div");
    const details = element("details", { open: Boolean(table.lead), class: "table" },
        element("summary", {}, element("bdi", {}, title), element("span", { class: "unit" }, rowWords(table))),
        content);
    const fill = () => {
        if (!details.open || content.hasChildNodes()) return;
        content.append(grid(table, title),
            saveButton("Save as CSV", fileName(table.file || table.name, ".csv"), () => csv(table), "text/csv"));
    };
    details.addEventListener("toggle", fill);
    fill();
    return details;
}

export function tablesSection(tables, level, title = "Tables") {
    return tables.length > 0 ? section(title, level, tables.map(foldedTable)) : null;
}

/** Pairs of a name and a text. */
export function pairs(entries, label) {
    return scroller(label, element("table", { class: "pairs" }, element("tbody", {}, entries.map(([name, text]) =>
        element("tr", {}, element("th", { scope: "row" }, pretty(String(name).replaceAll("_", " "))),
            element("td", { class: "text" }, element("bdi", {}, typeof text === "number" ? number(text, 17) : String(text ?? "–"))))))));
}
