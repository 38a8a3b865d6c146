// Atoms while they are computed: the scene and the camera of the report's viewer, without its playback.
import { ramp } from "../../../report/web/source/charts/key.js";
import { element } from "../../../report/web/source/dom.js";
import { pretty } from "../../../report/web/source/format.js";
import { roleNow } from "../../../report/web/source/palette.js";
import { Camera } from "../../../report/web/source/viewer/camera.js";
import { Pace } from "../../../report/web/source/viewer/pace.js";
import { AtomScene } from "../../../report/web/source/viewer/scene.js";
import { steer } from "../../../report/web/source/viewer/steer.js";
import { drawStill } from "../../../report/web/source/viewer/still.js";
import { word } from "./words.js";

const RADIUS = 0.5;     // of sigma
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;
const FASTEST = 3;      // thermal speeds, at the end of the ramp; as in src/page/page_run.cpp

function colours() {
    const style = getComputedStyle(document.documentElement);
    const get = (name) => style.getPropertyValue(name).trim();
    return { ground: get("--stage"), ink: get("--ink"), edge: get("--edge"), trace: roleNow(1) };
}

export class LiveAtoms {
    constructor(count, box) {
        this.count = count;
        this.box = box;
        this.positions = new Uint16Array(3 * count);
        this.speeds = new Uint8Array(count);
        // A long box lies across the picture.
        const isLong = Math.max(...box) > 1.5 * Math.min(...box);
        this.camera = new Camera(0.46 * Math.hypot(...box) + RADIUS, isLong ? { azimuth: 1.25, elevation: 0.2 } : undefined);
        this.canvas = element("canvas", {});
        this.stage = element("div", { class: "stage", tabindex: 0, role: "application", "aria-roledescription": "three-dimensional view", "aria-label": word("atoms label") }, this.canvas);
        this.node = element("div", {}, element("div", { class: "stage-frame" }, this.stage), ramp(0, FASTEST, pretty(word("speed legend"))));
        this.themed = () => { this.scene?.setColours(colours()); this.redraw(); };
        document.addEventListener("themechange", this.themed);
        try {
            this.scene = new AtomScene(this.canvas, count);
            const gl = this.scene.renderer.getContext();
            const names = gl.getExtension("WEBGL_debug_renderer_info");
            this.software = SOFTWARE.test(names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "");
            this.pace = new Pace(gl, count, (drawn) => this.draw(drawn));
            this.canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); this.fallBack("the graphics processor has stopped drawing"); });
            this.scene.setColours(colours());
            steer(this.stage, this.camera, { changed: () => this.pace?.moved(), click: () => {} });
        } catch (error) {
            this.fallBack(error.message);
        }
        new ResizeObserver(() => this.resize()).observe(this.stage);
    }

    fallBack(why) {
        this.scene = this.pace = null;
        const canvas = element("canvas", {});
        this.canvas.replaceWith(canvas);
        this.canvas = canvas;
        this.stage.setAttribute("role", "img");
        this.stage.removeAttribute("tabindex");
        this.stage.removeAttribute("aria-roledescription");
        this.node.prepend(element("p", { class: "why" }, word("no webgl", { why })));
        this.resize();
    }

    /** Shows the atoms of a frame, which come as the engine draws them. */
    show({ positions, speeds, edges }) {
        this.positions = positions;
        this.speeds = speeds;
        this.box = edges;
        if (this.scene) {
            this.scene.setFrame(positions, edges);
            this.scene.setShades(speeds);
            this.pace.moved();
            this.pace.drawNow();
        } else {
            this.redraw();
        }
    }

    /** Whether the last picture is still being drawn. */
    get busy() {
        return this.pace?.busy ?? false;
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.stage;
        if (width === 0 || height === 0) return;
        if (this.scene) {
            this.scene.setSize(width, height, this.software ? 1 : Math.min(window.devicePixelRatio, 2));
        } else {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        this.redraw();
    }

    redraw() {
        if (this.scene) this.pace.changed();
        else drawStill(this.canvas, { positions: this.positions, box: this.box, shades: this.speeds, radius: RADIUS }, this.camera, colours());
    }

    draw(drawn) {
        this.scene?.draw(this.camera, drawn);
        this.canvas.dataset.drawn = drawn;
    }

    resetView() {
        this.camera.reset();
        this.redraw();
    }

    /** A browser allows few WebGL contexts: the one of a run that is gone is given back. */
    close() {
        document.removeEventListener("themechange", this.themed);
        const { scene } = this;
        this.scene = this.pace = null;
        scene?.renderer.dispose();
        scene?.renderer.forceContextLoss();
    }
}
