// The picture of a run: the viewer that suits it, and of the pictures that come the newest, as soon as the one before is drawn.
import { element } from "../../../report/web/source/dom.js";
import { LiveAtoms } from "./live_atoms.js";
import { LiveBodies } from "./live_bodies.js";

export class Picture {
    /** @param {import("./client.js").Client} client is told when a picture is being drawn: then it computes the next one */
    constructor(client) {
        this.client = client;
        this.viewer = null;
        this.newest = null;     // waits to be drawn
        this.node = element("div", { class: "picture" });
    }

    /** Another run begins. A viewer of as many atoms in such a box is kept, with its camera. */
    renew(run) {
        this.newest = null;
        const same = run.kind === "fluid" && this.viewer instanceof LiveAtoms && this.viewer.count === run.atoms &&
            run.edges.every((edge, axis) => Math.abs(edge / this.viewer.box[axis] - 1) < 0.2);
        this.serial = run.serial;
        if (same) return;
        this.viewer?.close();
        this.viewer = run.kind === "fluid" ? new LiveAtoms(run.atoms, run.edges) : new LiveBodies(run);
        this.node.replaceChildren(this.viewer.node);
    }

    show(frame) {
        const isDrawing = this.newest !== null;
        this.newest = frame;
        if (document.hidden) {          // nothing is drawn in the background, and the run goes on
            this.newest = null;
            this.client.command("drawn");
        } else if (!isDrawing) {
            requestAnimationFrame(() => this.drawNewest());
        }
    }

    drawNewest() {
        if (this.newest === null) return;
        if (!document.hidden && this.viewer.busy) {
            setTimeout(() => this.drawNewest(), 2);
            return;
        }
        const frame = this.newest;
        this.newest = null;
        this.client.command("drawn");
        if (frame.serial === this.serial) this.viewer.show(frame);
    }
}
