// A chart as an SVG file of its own: light colours, white ground, title and legend inside.
import { pretty } from "../format.js";
import { distinct, sign } from "./key.js";

const SVG = "http://www.w3.org/2000/svg";
const VARIABLE = /var\((--[\w-]+)\)/g;

/** The light values of the CSS variables, read from an element that the style sheet keeps light. */
function lightColours() {
    const probe = document.createElement("div");
    probe.className = "always-light";
    document.body.append(probe);
    const style = getComputedStyle(probe);
    const values = new Map();
    return {
        get: (name) => {
            if (!values.has(name)) values.set(name, style.getPropertyValue(name).trim());
            return values.get(name);
        },
        done: () => probe.remove(),
    };
}

function label(text, x, y, weight) {
    const made = document.createElementNS(SVG, "text");
    made.textContent = text;
    for (const [name, value] of Object.entries({ x, y, "font-size": 12, "font-weight": weight, "text-anchor": "start", fill: "#1a1d21" })) made.setAttribute(name, value);
    return made;
}

/** @returns {string} */
export function svgText(svg, title, key) {
    const colours = lightColours();
    const copy = svg.cloneNode(true);
    for (const extra of copy.querySelectorAll('.cursor, g[aria-label="tip"]')) extra.remove();
    const [width, height] = [Number(svg.getAttribute("width")), Number(svg.getAttribute("height"))];
    const entries = distinct(key);
    const head = 26 + (entries.length > 0 ? 20 : 0);
    const group = document.createElementNS(SVG, "g");
    group.setAttribute("transform", `translate(0 ${head})`);
    group.append(...copy.childNodes);
    const ground = document.createElementNS(SVG, "rect");
    for (const [name, value] of Object.entries({ width, height: height + head, fill: "#fff" })) ground.setAttribute(name, value);
    copy.append(ground, label(title, 12, 20, 600));
    let x = 12;
    for (const entry of entries) {
        const place = document.createElementNS(SVG, "g");
        place.setAttribute("transform", `translate(${x} 30)`);
        place.append(sign(entry));
        const words = pretty(entry.label);
        copy.append(place, label(words, x + 28, 41, 400));
        x += 44 + 7 * words.length;
    }
    copy.append(group);
    copy.setAttribute("xmlns", SVG);
    copy.setAttribute("height", height + head);
    copy.setAttribute("viewBox", `0 0 ${width} ${height + head}`);
    copy.setAttribute("font-family", "system-ui, sans-serif");
    copy.style.color = "#1a1d21";
    const text = new XMLSerializer().serializeToString(copy).replace(VARIABLE, (_, name) => colours.get(name) || "currentColor");
    colours.done();
    return text;
}
