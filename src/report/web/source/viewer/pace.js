// Draws when something has changed, one picture at a time, and finds out how many atoms can be drawn while things move.

const SLOW = 80;        // milliseconds for a picture, above which a part of the atoms is left out
const FEWEST = 2000;
const REST = 250;       // milliseconds without a change, after which all are drawn

export class Pace {
    /**
     * @param {WebGL2RenderingContext} gl
     * @param {number} count of atoms
     * @param {(drawn: number) => void} draw
     */
    constructor(gl, count, draw) {
        this.gl = gl;
        this.count = count;
        this.draw = draw;
        this.budget = count;
        this.movedAt = -Infinity;
        this.busy = false;
        this.wanted = false;
    }

    /** Something has changed and will go on changing: speed before completeness. */
    moved() {
        this.movedAt = performance.now();
        clearTimeout(this.rest);
        this.rest = setTimeout(() => this.changed(), REST + 10);
        this.changed();
    }

    /** Something has changed. */
    changed() {
        if (this.wanted) return;
        this.wanted = true;
        if (!this.busy) requestAnimationFrame(() => this.picture());
    }

    /** Draws without waiting for the next frame of the browser: for callers that are called by it, if nothing is under way. */
    drawNow() {
        if (this.busy) return;
        this.wanted = true;
        this.picture();
    }

    picture() {
        if (!this.wanted || this.busy) return;
        this.wanted = false;
        this.busy = true;
        const moving = performance.now() - this.movedAt < REST;
        const drawn = moving ? this.budget : this.count;
        const begin = performance.now();
        this.draw(drawn);
        const { gl } = this;
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        const wait = () => {
            const done = fence === null || gl.isContextLost() || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
            if (!done && performance.now() - begin < 2000) {
                setTimeout(wait, 2);
                return;
            }
            if (fence) gl.deleteSync(fence);
            this.busy = false;
            this.adapt(drawn, performance.now() - begin);
            if (this.wanted) requestAnimationFrame(() => this.picture());
        };
        setTimeout(wait, 0);
    }

    /** Takes fewer atoms when a picture took long, and more again when it did not. */
    adapt(drawn, milliseconds) {
        if (milliseconds > SLOW) this.budget = Math.max(Math.min(FEWEST, this.count), Math.round((drawn * 0.8 * SLOW) / milliseconds));
        else if (milliseconds < SLOW / 2 && drawn >= this.budget) this.budget = Math.min(this.count, Math.round(this.budget * 1.3));
    }
}
