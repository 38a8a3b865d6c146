// Play, pause, step, speed: and how fast it goes.
import { element } from "../../../report/web/source/dom.js";
import { number } from "../../../report/web/source/format.js";
import { word } from "./words.js";

const PACES = [1, 2, 5, 10, 20, 50, 100, 0];    // steps a picture; 0: as many as there is time for
export const USUAL = { fluid: 4, "few-body": 1 };    // places among them

export class Transport {
    /** @param {import("./client.js").Client} client @param {() => void} step */
    constructor(client, step) {
        this.client = client;
        this.playing = false;
        this.pictures = [];
        this.button = element("button", { type: "button", class: "play", onclick: () => (this.playing ? this.pause() : this.play()) });
        this.pace = element("input", { type: "range", min: 0, max: PACES.length - 1, step: 1, value: USUAL.fluid, "aria-label": word("speed") });
        this.words = element("output", { class: "pace" });
        this.pace.addEventListener("input", () => this.setPace());
        this.rate = element("p", { class: "rate caption" });
        this.node = element("div", { class: "playback" }, this.button, element("button", { type: "button", class: "small", onclick: step }, word("step")), this.pace, this.words);
        this.label();
        this.setPace();
    }

    play() {
        if (this.over) return;
        this.playing = true;
        this.label();
        this.client.command("play");
    }

    pause() {
        this.playing = false;
        this.label();
        this.client.command("pause");
    }

    /** Whether the run has come to its end. */
    set finished(is) {
        this.over = is;
        this.button.disabled = is;
    }

    label() {
        this.button.textContent = this.playing ? "❚❚" : "►";
        this.button.setAttribute("aria-label", word(this.playing ? "pause" : "play"));
    }

    /** Another kind of run has another usual pace. */
    suit(kind) {
        if (this.kind === kind) return;
        this.kind = kind;
        this.pace.value = USUAL[kind];
        this.setPace();
    }

    setPace() {
        const steps = PACES[Number(this.pace.value)];
        this.words.textContent = steps === 0 ? word("full speed") : word(steps === 1 ? "one step a picture" : "steps a picture", { steps });
        this.pace.setAttribute("aria-valuetext", this.words.textContent);
        this.client.command("pace", { steps });
    }

    /** A picture was shown, so many steps after the one before. */
    count(steps) {
        this.pictures.push([performance.now(), steps]);
    }

    showRate() {
        const now = performance.now();
        this.pictures = this.pictures.filter(([at]) => now - at < 2000);
        if (!this.playing || this.pictures.length < 3) {
            this.rate.textContent = document.hidden && this.playing ? word("background") : "";
            return;
        }
        const seconds = (this.pictures.at(-1)[0] - this.pictures[0][0]) / 1000;
        const steps = this.pictures.slice(1).reduce((sum, [, taken]) => sum + taken, 0);
        this.rate.dataset.steps = String(steps / seconds);
        this.rate.dataset.pictures = String((this.pictures.length - 1) / seconds);
        this.rate.textContent = word("rate", { rate: number(Number((steps / seconds).toPrecision(3))), pictures: Math.round((this.pictures.length - 1) / seconds) });
    }
}
