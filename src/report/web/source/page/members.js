// Several runs on one page: their results side by side, their charts on top of each other.
import { element, scroller, section } from "../dom.js";
import { number, withSubscripts } from "../format.js";
import { levelSign, worst } from "./verdict.js";
import { valueText } from "./results.js";

const MOST_OVERLAID = 8;

/** Difference of two results in units of their common standard error; null where one has no error. */
export function distance(a, b) {
    const error = Math.hypot(a?.error ?? NaN, b?.error ?? NaN);
    return error > 0 && Number.isFinite(a.value) && Number.isFinite(b.value) ? (a.value - b.value) / error : null;
}

function comparedCell(quantity, first, isFirst) {
    if (!quantity) return element("td", {}, "–");
    const apart = isFirst ? null : distance(quantity, first);
    return element("td", { class: apart !== null && Math.abs(apart) > 3 ? "apart" : null }, valueText(quantity),
        apart === null ? null : element("span", { class: "unit" }, ` ${apart > 0 ? "+" : ""}${number(apart, 2)} errors`));
}

/** Quantities as rows, runs as columns. */
export function comparedSection(members, level) {
    const payloads = members.map((member) => member.payload);
    const names = [...new Set(payloads.flatMap((payload) => (payload.quantities ?? []).map((entry) => entry.name)))];
    if (names.length === 0) return null;
    const find = (payload, name) => (payload.quantities ?? []).find((entry) => entry.name === name);
    const rows = names.map((name) => {
        const entries = payloads.map((payload) => find(payload, name));
        const any = entries.find(Boolean);
        return element("tr", {},
            element("th", { scope: "row" }, name.replaceAll("_", " "), " ", any.unit && any.unit !== "1" ? element("span", { class: "unit" }, withSubscripts(any.unit)) : null),
            entries.map((entry, place) => comparedCell(entry, entries[0], place === 0)));
    });
    const table = element("table", { class: "results compared" },
        element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "Quantity"),
            members.map((member) => element("th", { scope: "col" }, element("bdi", {}, member.label))))),
        element("tbody", {}, rows));
    return section("Results side by side", level,
        element("p", { class: "caption" }, "Differences are from the first run, in combined standard errors; more than three are marked."),
        scroller("Results side by side", table));
}

/** What a chart is about: its axes. Charts of two kinds of runs may have the same name. */
const axes = (chart) => `${chart.x?.label}|${chart.y?.label}`;

/** Whether a mark draws two points or more: a single dot is no chart. */
function drawsSeveral(mark, table) {
    const values = (name) => table.values[table.columns.findIndex((column) => column.name === name)] ?? [];
    const y = values(mark.y);
    return values(mark.x).filter((x, row) => x !== null && y[row] !== null).length > 1;
}

/**
 * Charts that two members or more have, each member in a colour of its own.
 * @param {object[]} members
 * @param {object[]} there charts of the set itself: what they show is not shown again
 */
export function overlaidCharts(members, there) {
    const kinds = new Map();
    const tables = [];
    const words = members.length > MOST_OVERLAID ? `The first ${MOST_OVERLAID} of ${members.length} runs.` : "";
    members.slice(0, MOST_OVERLAID).forEach((member, place) => {
        for (const own of member.payload.charts ?? []) {
            const mark = own.marks?.find((entry) => ["line", "dots", "steps"].includes(entry.type) && !entry.group);
            const table = mark && (member.payload.tables ?? []).find((entry) => entry.name === mark.table);
            if (!table || !drawsSeveral(mark, table) || there.some((chart) => axes(chart) === axes(own))) continue;
            const name = `${place}/${table.name}`;
            if (!tables.some((entry) => entry.name === name)) tables.push({ ...table, name });
            const kind = `${own.id}|${axes(own)}`;
            if (!kinds.has(kind)) kinds.set(kind, { ...own, id: `compared-${own.id}`, caption: words, note: "", marks: [] });
            kinds.get(kind).marks.push({ ...mark, table: name, colour: place, label: member.label });
        }
    });
    return { charts: [...kinds.values()].filter((chart) => chart.marks.length > 1), tables };
}

/** Each run as a part that is drawn when it is opened. */
export function memberList(members, level, render) {
    return section("The runs", level, members.map((member) => {
        const content = element("div", { class: "member" });
        const details = element("details", { class: "run" }, element("summary", {}, levelSign(worst(member.payload.verdict ?? [])), " ",
            element("strong", {}, element("bdi", {}, member.label)), " ", element("bdi", {}, member.payload.title ?? "")), content);
        details.addEventListener("toggle", () => {
            if (details.open && !content.hasChildNodes()) content.append(...render(member.payload));
        });
        return details;
    }));
}
