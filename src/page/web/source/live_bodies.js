// A few bodies while they are computed: the report's drawing of tracks, with tracks that grow.
import { TrackViewer } from "../../../report/web/source/viewer/tracks.js";
import { word } from "./words.js";

const MOST = 3000;      // frames that are kept; then every other one is left out

/** Where a body is drawn: a pendulum's coordinate is an angle. */
function placeOf(force, [x, y, z]) {
    if (force === "pendulum") return [Math.sin(x), -Math.cos(x), 0];
    return [x, y, z];
}

export class LiveBodies {
    constructor(run) {
        this.force = run.force;
        this.bodies = run.masses.map((mass, place) => ({ name: run.masses.length > 1 ? String(place + 1) : "", mass }));
        // What the force acts from is drawn, too: the sun, the pivot.
        this.hasCentre = run.force === "pendulum" || /^\s*central_mass\s*=/m.test(run.deck);
        if (this.hasCentre) this.bodies.push({ name: run.force === "pendulum" ? "" : word("sun"), mass: run.force === "pendulum" ? 0 : 3 });
        this.node = document.createElement("div");
        this.frames = [];
        this.viewer = null;
    }

    show({ bodies }) {
        this.frames.push([...bodies.flatMap((body) => placeOf(this.force, body)), ...(this.hasCentre ? [0, 0, 0] : [])]);
        if (this.frames.length > MOST) this.frames = this.frames.filter((_, place) => place % 2 === 0);
        const positions = Float32Array.from(this.frames.flat());
        if (!this.viewer) {
            this.viewer = new TrackViewer({ bodies: this.bodies }, positions, this.force);
            this.viewer.playback.node.hidden = true;
            this.node.append(this.viewer.stage);
        }
        this.viewer.follow(positions);
    }

    get busy() {
        return this.viewer?.wanted ?? false;
    }

    resetView() {
        this.viewer?.camera.reset();
        this.viewer?.redraw();
    }

    close() {}
}
