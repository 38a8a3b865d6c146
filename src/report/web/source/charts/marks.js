// The marks of a chart as marks of Observable Plot.
import * as Plot from "@observablehq/plot";
import { number } from "../format.js";
import { css, inkOn, role, viridis } from "../palette.js";
import { categories, rowsOf } from "./rows.js";

const finite = (rows, ...names) => rows.filter((row) => names.every((name) => typeof row[name] === "string" || Number.isFinite(row[name])));

/** The name of a group for readers: a number in few digits. */
const titled = (name) => (name !== "" && Number.isFinite(Number(name)) ? number(Number(name), 4) : name);

/** Splits rows into series. A group has the same colour in all marks of a chart. */
function series(mark, rows, groups) {
    if (!mark.group) return [{ rows, colour: role(mark.colour ?? 0), label: mark.label }];
    return groups.map((name, place) => ({ rows: rows.filter((row) => row.group === name), colour: role(place), label: titled(name) }))
        .filter((entry) => entry.rows.length > 0);
}

/** The groups of all marks of a chart, in their order. */
export function groupsOf(chart, tables) {
    return categories((chart.marks ?? []).filter((mark) => mark.group).flatMap((mark) => rowsOf(mark, chart, tables).map((row) => row.group)));
}

function line({ rows, colour, label }, mark) {
    const band = finite(rows, "x", "low", "high");
    const dash = mark.dash ? "6 4" : null;
    return [
        band.length > 0 ? Plot.areaY(band, { x: "x", y1: "low", y2: "high", fill: colour, fillOpacity: 0.2, ariaHidden: "true" }) : null,
        Plot.lineY(rows, { x: "x", y: "y", stroke: colour, strokeWidth: rows.length > 1000 ? 1 : 1.6, strokeDasharray: dash, strokeLinejoin: "round", ariaDescription: label }),
    ];
}

function dots({ rows, colour, label }, mark) {
    const drawn = finite(rows, "x", "y");
    const sound = drawn.filter((row) => !row.flag);
    const suspect = drawn.filter((row) => row.flag);
    const many = drawn.length > 150;
    return [
        Plot.ruleX(finite(drawn, "low", "high"), { x: "x", y1: "low", y2: "high", stroke: colour, strokeWidth: 1.4, ariaHidden: "true" }),
        Plot.dot(sound, { x: "x", y: "y", r: many ? 2 : 3.5, fill: mark.open ? "var(--card)" : colour, stroke: colour, strokeWidth: mark.open ? 1.6 : 0.5, ariaDescription: label }),
        Plot.dot(suspect, { x: "x", y: "y", r: 5, symbol: "triangle", fill: "var(--card)", stroke: "var(--bad)", strokeWidth: 1.8, ariaDescription: `${label ?? ""} (suspect)` }),
    ];
}

function band({ rows, colour, label }) {
    return [Plot.areaY(finite(rows, "x", "low", "high"), { x: "x", y1: "low", y2: "high", fill: colour, fillOpacity: 0.22, ariaDescription: label })];
}

function steps({ rows, colour, label }) {
    return [Plot.lineY(rows, { x: "x", y: "y", stroke: colour, strokeWidth: 1.6, curve: "step-after", ariaDescription: label })];
}

function bars({ rows, colour, label }) {
    const drawn = finite(rows, "x", "y");
    return [
        Plot.barY(drawn, { x: "x", y: "y", fill: colour, insetLeft: 3, insetRight: 3, ariaDescription: label }),
        Plot.ruleX(finite(drawn, "low", "high"), { x: "x", y1: "low", y2: "high", stroke: "var(--ink)", strokeWidth: 1.4, ariaHidden: "true" }),
        Plot.ruleY([0], { stroke: "var(--faint-ink)" }),
    ];
}

/** A dashed line with its name beside it, at the upper end or at the right. Names of neighbours stand at two heights. */
function rule(mark, place) {
    const colour = role(mark.colour ?? 7);
    const line = { stroke: colour, strokeDasharray: "5 4", strokeWidth: 1.2, ariaDescription: mark.label };
    const name = { text: () => mark.label ?? "", fill: colour, stroke: "var(--card)", strokeWidth: 4, fontSize: 11, ariaHidden: "true" };
    return mark.type === "rule-x"
        ? [Plot.ruleX([mark.value], line), Plot.text([mark.value], { ...name, x: (value) => value, frameAnchor: "top", textAnchor: "start", dx: 4, dy: 1 + 13 * (place % 2), lineAnchor: "top" })]
        : [Plot.ruleY([mark.value], line), Plot.text([mark.value], { ...name, y: (value) => value, frameAnchor: "right", textAnchor: "end", dx: -2, dy: -7 })];
}

/** The range of a heat map's colours. */
export function fillRange(rows) {
    const fills = rows.map((row) => row.fill).filter(Number.isFinite);
    return [Math.min(...fills), Math.max(...fills)];
}

function cells(rows, label) {
    const [low, high] = fillRange(rows);
    const colour = (row) => viridis(high > low ? (row.fill - low) / (high - low) : 0.5);
    const drawn = finite(rows, "fill");
    const empty = rows.filter((row) => !Number.isFinite(row.fill));
    return [
        Plot.cell(drawn, { x: "x", y: "y", fill: (row) => css(colour(row)), inset: 0.5, ariaDescription: label }),
        Plot.text(empty, { x: "x", y: "y", text: () => "✕", fill: "var(--bad)", ariaDescription: "failed" }),
        drawn.length <= 150 ? Plot.text(drawn, { x: "x", y: "y", text: (row) => number(row.fill, 3), fill: (row) => inkOn(colour(row)), ariaHidden: "true" }) : null,
    ];
}

/** The colour of a z-score, by its size. */
function zColour(row) {
    const size = Math.abs(row.x);
    return size > 3 ? "var(--bad)" : size > 2 ? "var(--doubt)" : role(0);
}

function divergingDots(rows, label) {
    const drawn = finite(rows, "x", "y");
    const halves = [3, 2, 1].map((size) => ({ x1: -size, x2: size }));
    return [
        Plot.rect(halves, { x1: "x1", x2: "x2", fill: "var(--faint-ink)", fillOpacity: 0.08, ariaHidden: "true" }),
        Plot.ruleX([0], { stroke: "var(--faint-ink)" }),
        Plot.ruleY(drawn, { y: "y", x1: 0, x2: "x", stroke: zColour, strokeWidth: 1.2, ariaHidden: "true" }),
        Plot.dot(drawn.filter((row) => !row.flag), { x: "x", y: "y", r: 4, fill: zColour, ariaDescription: label }),
        Plot.dot(drawn.filter((row) => row.flag), { x: "x", y: "y", r: 5.5, symbol: "triangle", fill: "var(--card)", stroke: zColour, strokeWidth: 1.8, ariaDescription: `${label ?? ""} (suspect)` }),
    ];
}

const SERIES = { line, dots, band, steps, bars };
const SHAPES = { dots: "dot", band: "band", bars: "band" };

function shapeOf(mark) {
    if (mark.open) return "open";
    return SHAPES[mark.type] ?? (mark.dash ? "dash" : "line");
}

/**
 * @param {string[]} groups of the chart, see {@link groupsOf}
 * @param {number} place among the upright rules of the chart
 * @returns {{marks: object[], rows: object[], key: {label: string, colour: string, shape: string}[]}} Plot's marks, the
 *     rows that the pointer can find, and entries for the legend
 */
export function plotMarks(mark, chart, tables, groups, place) {
    if (mark.type === "rule-x" || mark.type === "rule-y") {
        return { marks: Number.isFinite(mark.value) ? rule(mark, place) : [], rows: [], key: [] };
    }
    const rows = rowsOf(mark, chart, tables);
    if (mark.type === "cells") return { marks: cells(rows, mark.label), rows, key: [] };
    if (mark.type === "diverging-dots") {
        const suspect = rows.some((row) => row.flag) ? [{ label: "suspect", colour: "var(--faint-ink)", shape: "triangle" }] : [];
        return { marks: divergingDots(rows, mark.label), rows, key: suspect };
    }
    const draw = SERIES[mark.type];
    if (!draw) return { marks: [], rows: [], key: [] };
    const all = series(mark, rows, groups);
    const shape = shapeOf(mark);
    const key = all.filter((entry) => entry.label).map((entry) => ({ label: entry.label, colour: entry.colour, shape }));
    if (rows.some((row) => row.flag)) key.push({ label: "suspect", colour: "var(--bad)", shape: "triangle" });
    return { marks: all.flatMap((entry) => draw(entry, mark)), rows: mark.type === "band" ? [] : rows.map((row) => ({ ...row, label: row.group ?? mark.label })), key };
}
