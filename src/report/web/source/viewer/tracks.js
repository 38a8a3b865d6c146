// A few bodies on their tracks, on a 2D canvas: lines of any width, names beside the bodies, and no WebGL needed.
import { element } from "../dom.js";
import { pretty } from "../format.js";
import { roleNow, ROLES } from "../palette.js";
import { fileName, save } from "../save.js";
import { Camera } from "./camera.js";
import { float32 } from "./decode.js";
import { Playback } from "./playback.js";
import { steer } from "./steer.js";

const TRAIL = 0.12;     // part of all frames
const PIECES = 12;      // of a trail, each fainter than the one before

/** The middle of what is shown and the radius that holds nearly all of it: an escaping body must not shrink the rest. */
function extent(positions) {
    const axes = [0, 1, 2].map((axis) => {
        const values = positions.filter((_, place) => place % 3 === axis).sort();
        const at = (part) => values[Math.round(part * (values.length - 1))];
        const [low, high] = [at(0.02), at(0.98)];
        return { middle: (low + high) / 2, half: (high - low) / 2 };
    });
    return { middle: axes.map((axis) => axis.middle), radius: 1.12 * Math.hypot(...axes.map((axis) => axis.half)) || 1, flat: axes[2].half < 1e-9 * axes[0].half };
}

export class TrackViewer {
    constructor(data, positions, title) {
        this.bodies = data.bodies;
        this.positions = positions;
        this.count = data.bodies.length;
        this.frames = Math.floor(positions.length / (3 * this.count));
        this.title = title;
        const { middle, radius, flat } = extent(positions);
        this.middle = middle;
        this.camera = new Camera(radius, flat ? { azimuth: 0, elevation: 0 } : undefined);
        this.canvas = element("canvas", {});
        this.stage = element("div", {
            class: "stage", tabindex: 0, role: "application", "aria-roledescription": "three-dimensional view",
            "aria-label": `Tracks of ${title}. Arrow keys turn, plus and minus zoom, 0 resets.`,
        }, this.canvas);
        this.playback = new Playback(this.frames, data.times ?? [], pretty(data.time_unit ?? ""), 20);
        const print = element("canvas", { class: "print-only always-light", width: 1200, height: 900, role: "img", "aria-label": `Tracks of ${title}` });
        window.addEventListener("beforeprint", () => {
            this.paint(print, 3, { ground: "#ffffff", ink: "#1a1d21" });
            // Chromium prints a canvas as strokes, and shaded discs see-through; its dots, drawn over them, are solid.
            print.getContext("2d").drawImage(print, 0, 0);
        });
        this.node = element("div", { class: "viewer" }, element("div", { class: "stage-frame" }, this.stage), print, this.playback.node,
            element("div", { class: "controls" },
                element("button", { type: "button", class: "small", onclick: () => { this.camera.reset(); this.redraw(); } }, "Reset view"),
                element("button", { type: "button", class: "small", onclick: () => this.canvas.toBlob((blob) => save(fileName(`${title}-tracks`, ".png"), blob)) }, "PNG")),
            data.words ? element("p", { class: "caption" }, pretty(data.words)) : null);
        steer(this.stage, this.camera, { changed: () => this.redraw(), click: () => {} });
        this.playback.onTime(() => this.redraw());
        document.addEventListener("themechange", () => this.redraw());
        new ResizeObserver(() => this.redraw()).observe(this.stage);
    }

    /** Shows the last frame of tracks that have grown. */
    follow(positions) {
        this.positions = positions;
        this.frames = Math.floor(positions.length / (3 * this.count));
        this.playback.frame = this.frames - 1;
        const { middle, radius } = extent(positions);
        this.middle = middle;
        this.camera.radius = radius;
        this.redraw();
    }

    redraw() {
        if (this.wanted) return;
        this.wanted = true;
        requestAnimationFrame(() => {
            this.wanted = false;
            const ratio = Math.min(window.devicePixelRatio, 2);
            const [width, height] = [this.stage.clientWidth * ratio, this.stage.clientHeight * ratio];
            if (width === 0) return;
            if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
            const style = getComputedStyle(document.documentElement);
            this.paint(this.canvas, ratio, { ground: style.getPropertyValue("--stage").trim(), ink: style.getPropertyValue("--ink").trim() });
            this.canvas.dataset.frame = this.playback.frame;
        });
    }

    /** Draws one body's way over some frames as one line. */
    line(pen, project, body, from, to) {
        pen.beginPath();
        for (let frame = from; frame <= to; ++frame) {
            const [x, y] = project(frame, body);
            if (frame === from) pen.moveTo(x, y);
            else pen.lineTo(x, y);
        }
        pen.stroke();
    }

    paint(canvas, ratio, { ground, ink }) {
        const pen = canvas.getContext("2d");
        const view = this.camera.projection(canvas.width, canvas.height);
        const project = (frame, body) => {
            const start = 3 * (frame * this.count + body);
            return view(...[0, 1, 2].map((axis) => this.positions[start + axis] - this.middle[axis]));
        };
        const now = this.playback.frame;
        const trail = Math.max(2, Math.round(TRAIL * this.frames));
        pen.fillStyle = ground;
        pen.fillRect(0, 0, canvas.width, canvas.height);
        pen.lineJoin = pen.lineCap = "round";
        this.bodies.forEach((_, body) => {
            pen.strokeStyle = roleNow(body % ROLES, canvas);
            pen.globalAlpha = 0.3;
            pen.lineWidth = ratio;
            this.line(pen, project, body, 0, this.frames - 1);
            pen.lineWidth = 2.6 * ratio;
            for (let piece = 0; piece < PIECES; ++piece) {
                const [from, to] = [piece, piece + 1].map((end) => Math.max(0, Math.round(now - trail + (trail * end) / PIECES)));
                pen.globalAlpha = (piece + 1) / PIECES;
                if (to > from) this.line(pen, project, body, from, to);
            }
            pen.globalAlpha = 1;
        });
        this.bodiesNow(canvas, (body) => project(now, body), ratio, ink, ground);
    }

    bodiesNow(canvas, project, ratio, ink, ground) {
        const pen = canvas.getContext("2d");
        const heaviest = Math.max(...this.bodies.map((body) => body.mass ?? 1)) || 1;
        pen.font = `600 ${13 * ratio}px system-ui, sans-serif`;
        const drawn = this.bodies.map((body, place) => ({ body, place, at: project(place) })).sort((a, b) => b.at[2] - a.at[2]);
        for (const { body, place, at: [x, y] } of drawn) {
            const size = ratio * (4.5 + 6.5 * Math.cbrt((body.mass ?? 1) / heaviest));
            const colour = roleNow(place % ROLES, canvas);
            const shade = pen.createRadialGradient(x - 0.35 * size, y - 0.4 * size, 0.1 * size, x, y, size);
            shade.addColorStop(0, `color-mix(in srgb, ${colour} 45%, white)`);
            shade.addColorStop(0.55, colour);
            shade.addColorStop(1, `color-mix(in srgb, ${colour} 65%, black)`);
            pen.fillStyle = shade;
            pen.beginPath();
            pen.arc(x, y, size, 0, 2 * Math.PI);
            pen.fill();
            pen.strokeStyle = ground;
            pen.lineWidth = 4 * ratio;
            pen.fillStyle = ink;
            pen.strokeText(body.name ?? "", x + size + 4 * ratio, y - size);
            pen.fillText(body.name ?? "", x + size + 4 * ratio, y - size);
        }
    }
}

/** @returns {TrackViewer|null} null where no frame is whole */
export function trackViewer(data, title) {
    const positions = float32(data.positions ?? "");
    return positions.length >= 3 * (data.bodies?.length ?? 0) && data.bodies?.length > 0 ? new TrackViewer(data, positions, title) : null;
}

/** The energy error along the tracks as a chart that follows the playback, and its table. */
export function energyErrorChart(data) {
    const chart = {
        id: "tracks-energy-error", title: "Energy error", lead: true, cursor: true,
        caption: "Relative error of the energy at the time of each frame. The line follows the playback; click to go to a time.",
        x: { label: data.time_unit ? `t / ${data.time_unit}` : "t" }, y: { label: "energy error" },
        marks: [{ type: "line", table: "tracks-energy-error", x: "time", y: "energy_error", colour: 0 }],
    };
    const table = { name: "tracks-energy-error", title: "Energy error along the tracks", columns: [{ name: "time" }, { name: "energy_error" }], values: [data.times, data.energy_error] };
    return { chart, table };
}
