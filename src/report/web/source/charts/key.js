// The legend of a chart: what its lines, dots and colours mean.
import { element } from "../dom.js";
import { number, pretty } from "../format.js";
import { css, viridis } from "../palette.js";

const SVG = "http://www.w3.org/2000/svg";
const SHAPES = {
    line: ["path", { d: "M0 6H22", "stroke-width": 2.2 }],
    dash: ["path", { d: "M0 6H22", "stroke-width": 2, "stroke-dasharray": "5 3" }],
    band: ["rect", { x: 0, y: 1, width: 22, height: 10, filled: 0.25 }],
    dot: ["circle", { cx: 11, cy: 6, r: 4, filled: 1 }],
    open: ["circle", { cx: 11, cy: 6, r: 3.6, "stroke-width": 1.7 }],
    triangle: ["path", { d: "M11 1L16.5 10.5H5.5Z", "stroke-width": 1.7 }],
};

/** What stands for an entry, as an SVG group that can stand in the page or in a saved chart. */
export function sign({ shapes, colour }) {
    const group = document.createElementNS(SVG, "g");
    for (const shape of shapes) {
        const [tag, { filled, ...attributes }] = SHAPES[shape];
        const made = document.createElementNS(SVG, tag);
        for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
        made.setAttribute("fill", filled ? colour : "none");
        if (filled) made.setAttribute("fill-opacity", filled);
        if (filled !== 1) made.setAttribute("stroke", filled ? "none" : colour);
        group.append(made);
    }
    return group;
}

/** One entry for what has the same name and colour: a line with its dots, a line with its band. */
export function distinct(key) {
    const entries = new Map();
    for (const { label, colour, shape } of key) {
        const name = `${label}|${colour}`;
        const entry = entries.get(name) ?? { label, colour, shapes: [] };
        if (!entry.shapes.includes(shape)) entry.shapes.push(shape);
        entries.set(name, entry);
    }
    return [...entries.values()];
}

export function keyList(key) {
    const entries = distinct(key);
    if (entries.length === 0) return null;
    return element("ul", { class: "key" }, entries.map((entry) => {
        const drawing = document.createElementNS(SVG, "svg");
        drawing.setAttribute("viewBox", "0 0 22 12");
        drawing.setAttribute("width", 22);
        drawing.setAttribute("height", 12);
        drawing.setAttribute("aria-hidden", "true");
        drawing.append(sign(entry));
        return element("li", {}, drawing, " ", element("bdi", {}, pretty(entry.label)));
    }));
}

/** The ramp of a heat map or of coloured atoms. */
export function ramp(low, high, label) {
    const stops = Array.from({ length: 11 }, (_, place) => css(viridis(place / 10))).join(", ");
    const bar = element("span", { class: "ramp" });
    bar.style.background = `linear-gradient(to right, ${stops})`;
    return element("p", { class: "ramp-line" }, number(low, 3), bar, number(high, 3), label ? ` ${label}` : null);
}
