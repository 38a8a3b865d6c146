// A chart on the page: heading, drawing, legend, caption, and a line that follows the playback.
import { element, uniqueId } from "../dom.js";
import { pretty } from "../format.js";
import { fileName, saveButton } from "../save.js";
import { drawChart } from "./draw.js";
import { svgText } from "./export.js";
import { keyList, ramp } from "./key.js";

// Widths on paper, in pixels: two charts side by side, and one alone in its row.
const PAPER = 380;
const PAPER_WIDE = 780;
const SVG = "http://www.w3.org/2000/svg";

/** Whether a chart has a row of two for itself on paper: a wide one, and one that is left over before it or at the end. */
function isAlone(node) {
    const isWide = (other) => !other || other.classList.contains("wide");
    if (isWide(node)) return true;
    let place = 0;
    for (let before = node.previousElementSibling; !isWide(before); before = before.previousElementSibling) ++place;
    return place % 2 === 0 && isWide(node.nextElementSibling);
}

/**
 * @param {object} chart
 * @param {Map<string, object>} tables
 * @param {{time: number, onTime: Function, seek: Function}|null} playback what a chart with `cursor` follows
 * @param {number} level of the heading
 * @returns {{node: HTMLElement, id: string, title: string, svg: () => string, redraw: () => void}} `redraw` after the
 *     tables have changed
 */
export function chartFigure(chart, tables, playback, level) {
    const place = element("div", { class: "drawing" });
    const below = element("div");
    const title = chart.title || chart.id;
    const caption = element("p", { id: uniqueId(`${chart.id} caption`), class: "caption" }, pretty(chart.caption ?? ""),
        chart.note ? element("span", { class: "note" }, " ", pretty(chart.note)) : null);
    let drawn = null;
    let width = 0;
    let onPaper = false;
    let cursor = null;

    const follow = () => {
        if (!cursor) return;
        const at = drawn.xScale.apply(playback.time);
        const [left, right] = drawn.xScale.range;
        // Outside the axis, and on the axis of values, a line would mislead.
        cursor.style.display = at > left && at <= right ? "" : "none";
        cursor.setAttribute("x1", at);
        cursor.setAttribute("x2", at);
    };
    const addCursor = () => {
        const height = Number(drawn.svg.getAttribute("height"));
        cursor = document.createElementNS(SVG, "line");
        for (const [name, value] of Object.entries({ class: "cursor", y1: 26, y2: height - 42 })) cursor.setAttribute(name, value);
        drawn.svg.append(cursor);
        drawn.svg.addEventListener("click", (event) => {
            const scale = drawn.svg.getBoundingClientRect().width / Number(drawn.svg.getAttribute("width"));
            playback.seek(drawn.xScale.invert((event.clientX - drawn.svg.getBoundingClientRect().left) / scale));
        });
        follow();
    };
    const draw = () => {
        drawn = drawChart(chart, tables, width, onPaper);
        drawn.svg.setAttribute("aria-describedby", caption.id);
        place.replaceChildren(drawn.svg);
        node.classList.toggle("tall", drawn.tall);
        node.classList.toggle("wide", drawn.wide);
        const several = drawn.key.length > 1 || drawn.key.some((entry) => entry.shape === "triangle");
        below.replaceChildren(...[several ? keyList(drawn.key) : null,
            drawn.fills?.length > 0 ? ramp(Math.min(...drawn.fills), Math.max(...drawn.fills), pretty(chart.fill_label ?? "")) : null].filter(Boolean));
        cursor = null;
        if (chart.cursor && playback) addCursor();
    };
    new ResizeObserver(([entry]) => {
        const now = Math.max(280, Math.floor(entry.contentRect.width));
        if (onPaper || now === width || entry.contentRect.width === 0) return;
        width = now;
        draw();
    }).observe(place);
    if (chart.cursor && playback) playback.onTime(follow);

    // On paper charts are narrower than on the screen; drawn for that width, their letters keep their size.
    let onScreen = 0;
    const drawFor = (paper) => {
        if (!drawn || paper === onPaper) return;
        const alone = isAlone(node) && !node.closest(".linked");
        if (paper) onScreen = width;
        width = !paper ? onScreen : alone ? PAPER_WIDE : PAPER;
        onPaper = paper;
        node.classList.toggle("alone", paper && alone);
        draw();
    };
    window.addEventListener("beforeprint", () => drawFor(true));
    window.addEventListener("afterprint", () => drawFor(false));

    const svg = () => {
        if (!drawn) {
            width = 720;
            draw();
        }
        return svgText(drawn.svg, title, drawn.key);
    };
    const node = element("figure", { class: chart.lead ? "chart lead" : "chart" },
        element("div", { class: "chart-head" }, element(`h${level}`, {}, element("bdi", {}, title)),
            saveButton("SVG", fileName(chart.id, ".svg"), svg, "image/svg+xml")),
        place, below, element("figcaption", {}, caption));
    node.querySelector("button").setAttribute("aria-label", `Save "${title}" as SVG`);
    const redraw = () => {
        if (width > 0) draw();
    };
    return { node, id: chart.id, title, svg, redraw };
}
