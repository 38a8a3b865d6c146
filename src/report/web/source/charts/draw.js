// A chart as SVG, by Observable Plot.
import * as Plot from "@observablehq/plot";
import { number, pretty, subscriptParts, withError } from "../format.js";
import { groupsOf, plotMarks } from "./marks.js";
import { categories } from "./rows.js";

const SVG = "http://www.w3.org/2000/svg";

function hint(row, chart) {
    if (row.tip) return row.tip;
    const x = typeof row.x === "string" ? row.x : `${pretty(chart.x?.label)} = ${number(row.x)}`;
    const value = typeof row.y === "string" ? row.y : `${pretty(chart.y?.label)} = ${withError(row.y, row.error)}`;
    return [row.label, x, value].filter(Boolean).join("\n").replace(/_(\w)/g, "$1");
}

/** Powers of ten, at most about eight of them. */
function decades(values) {
    const exponents = values.filter((value) => value > 0).map(Math.log10);
    const [low, high] = [Math.ceil(Math.min(...exponents) - 1e-9), Math.floor(Math.max(...exponents) + 1e-9)];
    const step = Math.max(1, Math.ceil((high - low) / 8));
    const ticks = [];
    for (let exponent = low; exponent <= high; exponent += step) ticks.push(10 ** exponent);
    return ticks.length > 1 ? ticks : undefined;
}

function axis(of, values, isCategory) {
    const options = { label: pretty(of?.label), grid: !isCategory, nice: false };
    if (isCategory) return { ...options, domain: categories(values) };
    const largest = Math.max(0, ...values.filter(Number.isFinite).map(Math.abs));
    if (of?.scale === "log") Object.assign(options, { type: "log", ticks: decades(values) });
    // Plot's own way with ticks is good, but for powers of ten.
    if (of?.scale === "log" || largest < 1e-3 || largest >= 1e6) options.tickFormat = (value) => number(value, 5);
    return options;
}

/** Sets what follows a `_` in the labels of the axes lower. */
function lowerSubscripts(svg) {
    for (const text of svg.querySelectorAll('g[aria-label$="axis label"] text')) {
        if (!text.textContent.includes("_")) continue;
        const parts = subscriptParts(text.textContent);
        text.replaceChildren();
        let lowered = false;
        for (const [plain, low] of parts) {
            for (const [content, isLow] of [[plain, false], [low, true]]) {
                if (content === "") continue;
                const span = document.createElementNS(SVG, "tspan");
                span.textContent = content;
                if (isLow !== lowered) span.setAttribute("dy", isLow ? "0.3em" : "-0.3em");
                if (isLow) span.setAttribute("font-size", "0.8em");
                lowered = isLow;
                text.append(span);
            }
        }
    }
}

/** A label is allowed on a group alone, so what has one is a group; it says which series it is. */
function nameParts(svg) {
    for (const part of svg.querySelectorAll("g[aria-label]")) {
        part.setAttribute("role", "group");
        const series = part.getAttribute("aria-description");
        if (!series) continue;
        part.setAttribute("aria-label", `${part.getAttribute("aria-label")}: ${series}`);
        part.removeAttribute("aria-description");
    }
}

/** Gives both axes the same length for one unit, around the middle of what is drawn. */
function equalScales(x, y, rows, width, height) {
    const ends = (values) => {
        const finite = values.filter(Number.isFinite);
        return [Math.min(...finite), Math.max(...finite)];
    };
    const [left, right] = ends(rows.map((row) => row.x));
    const [low, high] = ends(rows.map((row) => row.y));
    const unit = (1.04 * Math.max((right - left) / width, (high - low) / height)) / 2;
    if (!(unit > 0)) return;
    x.domain = [(left + right) / 2 - unit * width, (left + right) / 2 + unit * width];
    y.domain = [(low + high) / 2 - unit * height, (low + high) / 2 + unit * height];
}

// On paper charts are low, so that what does not fit on a sheet leaves little of it white.
const PAPER_HEIGHT = 175;

function heightOf(isScores, yIsCategory, rows, width, onPaper) {
    if (yIsCategory && onPaper) return Math.max((rows > 8 ? 14 : 20) * rows + 76, PAPER_HEIGHT);
    if (yIsCategory) return 80 + Math.max((isScores || rows > 12 ? 20 : 34) * rows, 120);
    return onPaper ? PAPER_HEIGHT : Math.round(Math.min(300, 170 + width / 6));
}

const longest = (values, most) => Math.max(0, ...values.map((value) => Math.min(String(value).length, most)));

/**
 * @param {object} chart of the payload
 * @param {Map<string, object>} tables by name
 * @param {number} width in pixels
 * @param {boolean} onPaper
 * @returns {{svg: SVGSVGElement, tall: boolean, wide: boolean, key: object[], fills: number[]|null, xScale: object}} tall: it has a
 *     row for itself on the screen; wide: on paper
 */
export function drawChart(chart, tables, width, onPaper) {
    const groups = groupsOf(chart, tables);
    const uprights = (chart.marks ?? []).filter((mark) => mark.type === "rule-x");
    const parts = (chart.marks ?? []).map((mark) => ({ mark, ...plotMarks(mark, chart, tables, groups, uprights.indexOf(mark)) }));
    const rows = parts.flatMap((part) => part.rows);
    const types = new Set(parts.map((part) => part.mark.type));
    const isMap = types.has("cells");
    const isScores = types.has("diverging-dots");
    const xIsCategory = isMap || types.has("bars") || chart.x?.scale === "category";
    const yIsCategory = isMap || isScores || chart.y?.scale === "category";
    const ruled = (type) => (chart.marks ?? []).filter((mark) => mark.type === type).map((mark) => mark.value);
    const y = axis(chart.y, [...rows.map((row) => row.y), ...(yIsCategory ? [] : ruled("rule-y"))], yIsCategory);
    if (isMap) y.reverse = true;
    const x = axis(chart.x, rows.map((row) => row.x), xIsCategory);
    // Dots at the ends of an axis are seen whole.
    const hasDots = isScores || types.has("dots");
    if (hasDots && !xIsCategory) x.inset = 6;
    if (hasDots && !yIsCategory) y.inset = 6;
    if (!xIsCategory) x.tickSpacing = 56;
    const most = width < 500 ? 22 : 44;
    const short = (value) => {
        const text = typeof value === "number" ? number(value) : pretty(value);
        return text.length > most ? `${text.slice(0, most - 1)}…` : text;
    };
    if (yIsCategory) y.tickFormat = short;
    if (xIsCategory) x.tickFormat = short;
    if (isScores) Object.assign(y, { label: null });
    const turned = xIsCategory && longest(x.domain, 30) * 7 * x.domain.length > width - 80;
    if (turned) x.tickRotate = -40;
    const pointed = rows.filter((row) => [row.x, row.y].every((value) => typeof value === "string" || Number.isFinite(value)));
    const find = isMap || isScores || types.has("dots") ? Plot.pointer : Plot.pointerX;
    // A path in space keeps its shape.
    const isPath = chart.equal ?? (/^x( |$)/.test(chart.x?.label ?? "") && /^y( |$)/.test(chart.y?.label ?? ""));
    // The name of an upright rule behind all points stands in the margin.
    const ruleIsLast = rows.length > 0 && ruled("rule-x").some((value) => rows.every((row) => !(row.x > value)));
    const height = isPath ? Math.min(width - 12, onPaper ? 1.3 * PAPER_HEIGHT : 480) : heightOf(isScores, yIsCategory, y.domain?.length ?? 0, width, onPaper);
    if (isPath) equalScales(x, y, rows, width - 80, height - 68);
    const svg = Plot.plot({
        width,
        height,
        marginLeft: yIsCategory ? 24 + 6.6 * longest(y.domain.map(short), most) : 62,
        marginBottom: turned ? 34 + 4.2 * longest(x.domain, most) : 42,
        marginTop: 26, marginRight: ruleIsLast ? 58 : 18,
        style: { fontSize: "12px", fontFamily: "inherit", overflow: "visible", background: "transparent", color: "inherit" },
        ariaLabel: chart.title,
        x, y,
        marks: [
            ...parts.flatMap((part) => part.marks).filter(Boolean),
            pointed.length > 0 ? Plot.tip(pointed, find({ x: "x", y: "y", title: (row) => hint(row, chart), fill: "var(--card)", stroke: "var(--line)", ariaHidden: "true" })) : null,
        ].filter(Boolean),
    });
    svg.setAttribute("role", "img");
    nameParts(svg);
    lowerSubscripts(svg);
    const fills = isMap ? parts.flatMap((part) => (part.mark.type === "cells" ? part.rows.map((row) => row.fill) : [])).filter(Number.isFinite) : null;
    const tall = yIsCategory && y.domain.length > 15;
    const wide = (tall && longest(y.domain.map(short), most) > 20) || (xIsCategory && x.domain.length > 18);
    return { svg, tall, wide, key: parts.flatMap((part) => part.key), fills, xScale: svg.scale("x") };
}
