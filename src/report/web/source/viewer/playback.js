// Goes through the frames of a run: play, slider, speed.
import { element } from "../dom.js";
import { number } from "../format.js";

const SPEEDS = [["0.25", "¼ ×"], ["0.5", "½ ×"], ["1", "1 ×"], ["2", "2 ×"], ["4", "4 ×"]];

export class Playback {
    /**
     * @param {number} frames
     * @param {number[]} times of the frames
     * @param {string} unit of the times
     * @param {number} seconds that all frames take at speed 1
     */
    constructor(frames, times, unit, seconds) {
        this.seconds = seconds;
        this.frames = frames;
        this.times = times;
        this.unit = unit;
        this.frame = 0;
        this.playing = false;
        this.listeners = [];
        this.ready = () => true;    // false while the frame before is still being drawn
        this.speed = 1;
        this.node = this.controls();
        this.show(0);
    }

    get time() {
        return this.times[this.frame] ?? this.frame;
    }

    /** Calls back after each change of the frame. */
    onTime(listener) {
        this.listeners.push(listener);
    }

    show(frame) {
        this.frame = Math.min(Math.max(frame, 0), this.frames - 1);
        const words = `t = ${number(this.time, 5)}${this.unit ? ` ${this.unit}` : ""}`;
        this.slider.value = String(this.frame);
        this.slider.setAttribute("aria-valuetext", `frame ${this.frame + 1} of ${this.frames}, ${words}`);
        this.words.textContent = `${words}  ·  ${this.frame + 1}/${this.frames}`;
        for (const listener of this.listeners) listener(this.frame);
    }

    /** Shows the frame that is nearest to a time. */
    seek(time) {
        let best = 0;
        for (let frame = 1; frame < this.frames; ++frame) {
            if (Math.abs(this.times[frame] - time) < Math.abs(this.times[best] - time)) best = frame;
        }
        this.show(best);
    }

    play() {
        if (this.playing) return;
        this.playing = true;
        this.label();
        if (this.frame === this.frames - 1) this.show(0);
        let at = this.frame;
        let before = null;
        let shown = this.frame;
        const moved = () => this.frame !== shown;  // by the slider or a chart
        const tick = (now) => {
            if (!this.playing) return;
            if (moved()) at = this.frame;
            at += before === null ? 0 : (Math.min(now - before, 500) / 1000) * this.speed * (this.frames / this.seconds);
            before = now;
            const frame = Math.floor(at) % this.frames;
            if (frame !== this.frame && this.ready()) this.show(frame);
            shown = this.frame;
            requestAnimationFrame(tick);
        };
        requestAnimationFrame(tick);
    }

    pause() {
        this.playing = false;
        this.label();
    }

    label() {
        this.button.textContent = this.playing ? "❚❚" : "►";
        this.button.setAttribute("aria-label", this.playing ? "Pause" : "Play");
    }

    controls() {
        this.button = element("button", { type: "button", class: "play", onclick: () => (this.playing ? this.pause() : this.play()) });
        this.label();
        this.slider = element("input", { type: "range", min: 0, max: this.frames - 1, step: 1, value: 0, "aria-label": "Frame" });
        this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
        this.words = element("output", { class: "time" });
        const speed = element("select", { "aria-label": "Speed of the playback" }, SPEEDS.map(([value, text]) =>
            element("option", { value, selected: value === "1" }, text)));
        speed.addEventListener("change", () => (this.speed = Number(speed.value)));
        return element("div", { class: "playback", hidden: this.frames < 2 }, this.button, this.slider, this.words, speed);
    }
}
