// The atoms of a run: a picture that turns and plays, its controls, and a still where there is no WebGL.
import { element, uniqueId } from "../dom.js";
import { ramp } from "../charts/key.js";
import { number, pretty } from "../format.js";
import { roleNow } from "../palette.js";
import { fileName, save } from "../save.js";
import { Camera } from "./camera.js";
import { coloursAt, decodeAtoms } from "./decode.js";
import { Pace } from "./pace.js";
import { pick, way } from "./pick.js";
import { Playback } from "./playback.js";
import { AtomScene } from "./scene.js";
import { steer } from "./steer.js";
import { drawStill } from "./still.js";

const RADIUS = 0.5;     // of sigma
const SMALL = 0.16;
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

function pageColours() {
    const style = getComputedStyle(document.documentElement);
    const get = (name) => style.getPropertyValue(name).trim();
    return { ground: get("--stage"), ink: get("--ink"), edge: get("--edge"), trace: roleNow(1) };
}

export class AtomViewer {
    /** @param {object} data `atoms` of the payload; null is returned by {@link atomViewer} where no frame is whole */
    constructor(data, atoms, title) {
        this.data = data;
        this.atoms = atoms;
        this.title = title;
        this.picked = -1;
        this.colour = atoms.colours[0];
        const box = atoms.box(0);
        this.camera = new Camera(0.46 * Math.hypot(...box) + RADIUS);  // corners come near the frame, no atom leaves it
        this.canvas = element("canvas", {});
        this.stage = element("div", {
            class: "stage", tabindex: 0, role: "application", "aria-roledescription": "three-dimensional view",
            "aria-label": `Atoms of ${title}. Arrow keys turn, plus and minus zoom, 0 resets.`,
        }, this.canvas);
        this.thin = element("p", { class: "thin", "aria-hidden": "true" });
        this.info = element("p", { class: "picked", "aria-live": "polite" });
        this.playback = new Playback(atoms.frames, atoms.times, pretty(data.time_unit ?? "tau"), 8);
        this.node = this.layout();
        this.begin();
    }

    layout() {
        const { colours, count } = this.atoms;
        this.choice = element("select", { id: uniqueId("colour") }, colours.map((colour) => element("option", { value: colour.name }, colour.name.replaceAll("_", " "))));
        this.choice.addEventListener("change", () => this.setColour(colours.find((colour) => colour.name === this.choice.value)));
        this.legend = element("div", { class: "legend" });
        this.boxSwitch = element("input", { type: "checkbox", checked: true });
        this.boxSwitch.addEventListener("change", () => this.redraw());
        this.traceSwitch = element("input", { type: "checkbox" });
        this.traceSwitch.addEventListener("change", () => this.select(this.picked < 0 ? 0 : this.picked));
        this.atomField = element("input", { id: uniqueId("atom"), type: "number", min: 0, step: 1, placeholder: "click one" });
        this.atomField.addEventListener("change", () => this.select(this.atomField.value === "" ? -1 : this.placeOf(Number(this.atomField.value))));
        const stillOf = element("canvas", { class: "print-only", width: 1200, height: 900, role: "img", "aria-label": `Atoms of ${this.title}` });
        window.addEventListener("beforeprint", () => this.drawStillOn(stillOf, { ground: "#ffffff", edge: "#9aa3ad" },
            this.playback.frame || this.atoms.frames - 1));    // the end of the run, where nobody chose another frame
        this.controls = element("div", { class: "controls" },
            element("span", {}, element("label", { for: this.choice.id }, "Colour "), this.choice),
            element("label", { class: "live" }, this.boxSwitch, " Box"),
            element("span", { class: "live" }, element("label", { for: this.atomField.id }, "Atom "), this.atomField),
            element("label", { class: "live" }, this.traceSwitch, " Trace"),
            element("button", { type: "button", class: "small live", onclick: () => { this.camera.reset(); this.moved(); } }, "Reset view"),
            element("button", { type: "button", class: "small", onclick: () => this.savePicture() }, "PNG"));
        return element("div", { class: "viewer" }, element("div", { class: "stage-frame" }, this.stage, this.thin), stillOf,
            this.playback.node, this.controls, this.legend, this.info,
            element("p", { class: "caption" }, this.data.words ? `${pretty(this.data.words)} ` : null,
                `${number(count)} atoms.`));
    }

    begin() {
        try {
            this.scene = new AtomScene(this.canvas, this.atoms.count);
        } catch (error) {
            this.fallBack(`The atoms cannot be turned here: ${error.message}. This is a still picture.`);
        }
        if (this.scene) this.goLive();
        this.playback.onTime(() => this.showFrame());
        document.addEventListener("themechange", () => { this.recolour(); this.redraw(); });
        new ResizeObserver(() => this.resize()).observe(this.stage);
        this.recolour();
        this.setColour(this.colour);
        this.showFrame();
    }

    goLive() {
        const gl = this.scene.renderer.getContext();
        const names = gl.getExtension("WEBGL_debug_renderer_info");
        this.software = SOFTWARE.test(names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "");
        this.pace = new Pace(gl, this.atoms.count, (drawn) => this.draw(drawn));
        this.playback.ready = () => !this.pace.busy;
        steer(this.stage, this.camera, { changed: () => this.moved(), click: (x, y) => this.pickAt(x, y) });
        this.canvas.addEventListener("webglcontextlost", (event) => {
            event.preventDefault();
            this.fallBack("The graphics processor has stopped drawing. This is a still picture; load the page again to turn it.");
            this.resize();
        });
    }

    /** Goes on without WebGL: a canvas that gave a WebGL context gives no other, so it is replaced. */
    fallBack(reason) {
        this.scene = this.pace = null;
        this.playback.ready = () => true;
        const canvas = element("canvas", {});
        this.canvas.replaceWith(canvas);
        this.canvas = canvas;
        this.node.classList.add("still");
        this.stage.setAttribute("role", "img");
        this.stage.removeAttribute("tabindex");
        this.stage.removeAttribute("aria-roledescription");
        this.stage.setAttribute("aria-label", `Atoms of ${this.title}, a still picture`);
        this.node.prepend(element("p", { class: "why" }, reason));
    }

    positions(frame = this.playback.frame) {
        return this.atoms.positions.subarray(3 * frame * this.atoms.count, 3 * (frame + 1) * this.atoms.count);
    }

    showFrame() {
        const { frame } = this.playback;
        if (this.scene) {
            this.scene.setFrame(this.positions(), this.atoms.box(frame));
            this.scene.setShades(coloursAt(this.colour, frame, this.atoms.count));
        }
        this.describePicked();
        if (this.playback.playing && this.pace) {
            this.pace.moved();
            this.pace.drawNow();
        } else {
            this.redraw();
        }
        this.canvas.dataset.frame = frame;
    }

    setColour(colour) {
        this.colour = colour;
        this.legend.replaceChildren(ramp(colour.low, colour.high, pretty(colour.label)));
        this.showFrame();
    }

    recolour() {
        this.scene?.setColours(pageColours());
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.stage;
        if (width === 0 || height === 0) return;
        if (this.scene) {
            this.scene.setSize(width, height, this.software ? 1 : Math.min(window.devicePixelRatio, 2));
        } else {
            this.canvas.width = width * Math.min(window.devicePixelRatio, 2);
            this.canvas.height = height * Math.min(window.devicePixelRatio, 2);
        }
        this.redraw();
    }

    moved() {
        if (this.pace) this.pace.moved();
        else this.redraw();
    }

    redraw() {
        if (this.scene) this.pace.changed();
        else this.drawStillOn(this.canvas, pageColours());
    }

    draw(drawn) {
        if (!this.scene) return;
        this.scene.edges.visible = this.boxSwitch.checked;
        this.scene.trace.visible = this.traceSwitch.checked && this.picked >= 0;
        // Among full spheres a way would be hidden.
        this.scene.uniforms.radius.value = this.scene.trace.visible ? SMALL : RADIUS;
        this.scene.draw(this.camera, drawn);
        this.canvas.dataset.drawn = drawn;
        this.thin.textContent = drawn < this.atoms.count ? `while moving: ${number(drawn)} of ${number(this.atoms.count)} atoms are drawn` : "";
    }

    drawStillOn(canvas, colours, frame = this.playback.frame) {
        drawStill(canvas, {
            positions: this.positions(frame), box: this.atoms.box(frame), shades: coloursAt(this.colour, frame, this.atoms.count), radius: RADIUS,
        }, this.camera, colours);
    }

    pickAt(x, y) {
        const { clientWidth: width, clientHeight: height } = this.stage;
        this.select(pick(this.positions(), this.atoms.box(this.playback.frame), RADIUS, this.camera.projection(width, height), x, y));
    }

    idOf(place) {
        return this.atoms.ids ? this.atoms.ids[place] : place;
    }

    placeOf(id) {
        if (this.atoms.ids) return this.atoms.ids.indexOf(id);
        return Number.isInteger(id) && id >= 0 && id < this.atoms.count ? id : -1;
    }

    /** Marks an atom; -1: none. */
    select(place) {
        this.picked = place;
        this.atomField.value = place < 0 ? "" : String(this.idOf(place));
        if (this.scene) {
            this.scene.uniforms.picked.value = place;
            if (place >= 0) this.scene.setTrace(way(this.atoms, place));
        }
        this.describePicked();
        this.redraw();
    }

    describePicked() {
        if (this.picked < 0) {
            this.info.textContent = "";
            return;
        }
        const { frame } = this.playback;
        const values = this.atoms.colours.filter((colour) => !colour.still).map((colour) => {
            const value = coloursAt(colour, frame, this.atoms.count)[this.picked] / 255;
            return `${pretty(colour.label || colour.name)}: ${number(colour.low + value * (colour.high - colour.low), 3)}`;
        });
        this.info.textContent = [`Atom ${this.idOf(this.picked)}`, ...values].join("  ·  ");
    }

    savePicture() {
        if (this.scene) this.scene.draw(this.camera, this.atoms.count);
        this.canvas.toBlob((blob) => save(fileName(`${this.title}-atoms`, ".png"), blob));
    }
}

/** @returns {AtomViewer|null} */
export function atomViewer(data, title) {
    const atoms = decodeAtoms(data);
    return atoms ? new AtomViewer(data, atoms, title) : null;
}
