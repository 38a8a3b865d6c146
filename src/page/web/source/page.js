// A run on the page: what is opened, how it goes on, what is shown of it.
import { element } from "../../../report/web/source/dom.js";
import { number } from "../../../report/web/source/format.js";
import { Controls } from "./controls.js";
import { fluidDeck, pastOf, reversalDeck, START } from "./decks.js";
import { Exercises } from "./exercises.js";
import { LiveCharts } from "./live_charts.js";
import { Numbers } from "./numbers.js";
import { Picture } from "./picture.js";
import { FEW_BODIES, FLUIDS } from "./scenes.js";
import { START_FILE, Texts } from "./texts.js";
import { Transport } from "./transport.js";
import { word } from "./words.js";

const KNOW = 700;       // milliseconds between looks at the averages
const MOST_ROWS = 6000;
const MOST_STAGES = 10; // of a run that is told as one deck
const MOST_WORK = 1.5e7; // steps of one atom that are computed again for it
const SLICE = 500;      // steps that are computed at once where nobody looks

/* global ljmdFewBodies, ljmdDiagram: decks of inputs/fewbody by name, and lines of the phase diagram; put here by build.mjs */

export class Page {
    constructor(client, version) {
        this.client = client;
        this.version = version;
        this.controls = { ...START };
        this.known = { rows: [], tables: [], place: {}, fluid: null, controls: this.controls, diagram: ljmdDiagram };
        this.opening = Promise.resolve();
        this.ofText = () => this.openText();
        this.layout();
        client.on("frame", (frame) => this.show(frame));
        client.on("stopped", (error) => this.stop(error));
        setInterval(() => this.look(), KNOW);
        window.addEventListener("beforeprint", () => this.charts.update(this.known));
    }

    layout() {
        const button = (name, act, more = {}) => element("button", { type: "button", class: "small", onclick: act, ...more }, word(name));
        this.transport = new Transport(this.client, () => this.guard(() => this.step()));
        this.texts = new Texts({
            run: () => this.guard(this.ofText), link: () => this.guard(() => this.texts.copyLink()), verify: () => this.guard(() => this.verify()),
        });
        this.flip = element("input", { type: "checkbox" });
        this.flip.addEventListener("change", () => { if (this.run?.stages[1]?.reverse) this.guard(() => this.again()); });
        this.reverseButton = button("reverse", () => this.guard(() => this.reverse()));
        this.stateWords = element("p", { class: "time" });
        this.about = element("p", { class: "about" });
        this.verdict = element("p", { class: "verdict-line", role: "status", hidden: true });
        this.trouble = element("div", { class: "trouble", role: "alert", hidden: true });
        this.picture = new Picture(this.client);
        this.sliders = new Controls({
            moved: (values) => this.nameStateSoon(values),
            changed: (key, value) => this.guard(() => this.change(key, value)),
        });
        this.numbers = new Numbers();
        this.charts = new LiveCharts();
        this.exercises = new Exercises(() => this.known.results);
        this.scenes = new Map();
        const scene = (name, open) => {
            const made = element("button", { type: "button", class: "scene", "aria-pressed": "false", title: word(`about ${name}`), onclick: () => this.guard(open) }, word(`scene ${name}`));
            this.scenes.set(name, made);
            return made;
        };
        this.node = element("main", { id: "content", tabindex: -1 },
            element("div", { class: "hero" }, element("h1", {}, word("title")), element("p", {}, word("lead"))),
            element("nav", { class: "scenes", "aria-label": word("scenes") },
                element("div", { role: "group", "aria-label": word("fluids") }, Object.keys(FLUIDS).map((name) => scene(name, () => this.openScene(name)))),
                element("div", { role: "group", "aria-label": word("few bodies") }, Object.keys(FEW_BODIES).map((name) => scene(name, () => this.openFewBodies(name))))),
            element("div", { class: "table" },
                element("section", { class: "viewer", "aria-label": word("atoms label") }, this.about, this.picture.node,
                    this.transport.node,
                    element("div", { class: "controls" }, this.stateWords, button("again", () => this.guard(() => this.again())), this.reverseButton,
                        element("label", { class: "check" }, this.flip, ` ${word("flip")}`), button("reset view", () => this.picture.viewer?.resetView())),
                    this.verdict, this.trouble, this.transport.rate),
                element("div", { class: "side" }, this.sliders.node, this.numbers.node)),
            element("section", { "aria-labelledby": "charts" }, element("h2", { id: "charts" }, word("charts")), this.charts.node),
            element("section", { class: "texts" }, this.texts.deckPart, this.texts.homePart, this.exercises.node));
    }

    // What is run.

    /** Opens a deck. @param {object} how `start`: the text of its start file; `shown`: name of the scene */
    async open(deck, { start = null, shown = null, about = null, force = false, flip = -1, playing = true, name = "page.toml" } = {}) {
        const run = await this.client.call("open", { name, deck, settings: [], force, files: start ? { [START_FILE]: start } : {}, flip });
        this.transport.pause();
        this.trouble.hidden = this.texts.messages.hidden = this.verdict.hidden = true;
        this.run = run;
        this.start = start;
        this.shown = shown;
        this.past = pastOf(deck);
        this.texts.show(deck, start, force, run.warnings);
        this.flipped = flip;
        const fluid = run.kind === "fluid";
        this.transport.suit(run.kind);
        this.known = {
            ...this.known, rows: [], tables: [], results: null, speeds: null, fluid, controls: this.controls, kept: start !== null,
            place: Object.fromEntries(run.columns.map((column, place) => [column, place])),
            firstSampled: this.stepsBefore((stage) => stage.sample),
        };
        this.about.textContent = word(about ?? (shown ? `about ${shown}` : "about deck"));
        for (const [scene, made] of this.scenes) made.setAttribute("aria-pressed", String(scene === shown));
        this.reverseButton.disabled = !fluid;
        this.flip.disabled = !fluid;
        this.picture.renew(run);
        this.node.classList.toggle("bodies", !fluid);
        this.node.classList.toggle("film", fluid && this.controls.film);
        const first = await this.client.call("advance", { steps: 0, shown: true });
        this.take(first);
        this.charts.update(this.known);
        this.numbers.update(null, null, this.controls);
        if (playing) this.transport.play();
        return run;
    }

    stepsBefore(test) {
        let steps = 0;
        for (const stage of this.run.stages) {
            if (test(stage)) return steps;
            steps += stage.steps;
        }
        return steps;
    }

    async openScene(name) {
        const { from, reversal, ...controls } = FLUIDS[name];
        this.setControls(controls);
        if (reversal) {
            await this.open(reversalDeck(controls, false, reversal), { shown: name, flip: this.flipAfter(reversal, controls.timeStep) });
            return;
        }
        let start = null;
        if (from) {
            // From a hotter fluid, made at once.
            await this.open(fluidDeck({ ...controls, ...from, equilibration: 300, production: 100, measured: false }, false), { shown: name, playing: false });
            await this.compute(300);
            start = await this.client.call("configuration");
        }
        await this.open(fluidDeck(controls, start !== null), { start, shown: name });
    }

    async openFewBodies(name) {
        await this.open(ljmdFewBodies[FEW_BODIES[name]], { shown: name, name: `${FEW_BODIES[name]}.toml` });
    }

    async openText() {
        const deck = this.texts.deck.value;
        const start = deck.includes(START_FILE) ? this.start : null;
        await this.open(deck, { start, force: this.texts.force.checked });
        this.readControls();
    }

    async again() {
        const [there, back] = this.run.stages;
        const flip = back?.reverse ? this.flipAfter(there.steps, there.time_step) : -1;
        await this.open(this.texts.deck.value, { start: this.start, shown: this.shown, force: this.texts.force.checked, flip });
    }

    /** The time of a flipped bit, a twentieth of the way back; none is flipped unless it is asked for. */
    flipAfter(steps, timeStep) {
        return this.flip.checked ? (steps + Math.ceil(steps / 20)) * timeStep : -1;
    }

    /** A slider was let go: the run goes on with another stage, or from where the atoms are, or anew. */
    async change(key, value) {
        const before = this.controls;
        const controls = { ...before, [key]: value, equilibration: 500 };
        if (key === "density" && controls.film) controls.film = false;
        try {
            this.setControls(controls);
            if (key === "cells" || this.run?.kind !== "fluid" || controls.film) await this.open(fluidDeck(controls, false), { shown: this.shown });
            else if (["temperature", "timeStep", "held"].includes(key) && this.canGoOn()) await this.goOn(controls, key);
            else await this.goFromHere(controls, key);
        } catch (error) {
            this.setControls(before);
            throw error;
        }
    }

    /** Whether the run can be told as one deck from its crystal on, and computed again in a few seconds. */
    canGoOn() {
        const work = this.state.step * this.run.atoms;
        return this.start === null && !this.controls.film && this.past !== undefined && this.past.length < MOST_STAGES && work < MOST_WORK;
    }

    /** The same run with another stage from now on: it is computed again up to here, and time goes on. */
    async goOn(controls, key) {
        this.transport.pause();
        await this.client.call("version");      // what the Worker had under way has come
        const { step } = this.state;
        const { rows } = this.known;
        let left = step;
        const past = this.run.stages.map((stage, place) => {
            const steps = Math.min(stage.steps, left);
            left -= steps;
            return { ...this.past[place], steps };
        }).filter((stage) => stage.steps > 0);
        await this.open(fluidDeck({ ...controls, equilibration: key === "temperature" && controls.held ? 500 : 0 }, false, past), { shown: this.shown, playing: false });
        await this.compute(step);
        this.known.rows = rows;     // of which some are kept, and these are computed again
        this.transport.play();
    }

    /** A run that begins with the atoms as they are. */
    async goFromHere(controls, key) {
        const start = await this.client.call("configuration");
        if (["timeStep", "held"].includes(key)) controls.equilibration = 0;
        await this.open(fluidDeck({ ...controls, atoms: this.run.atoms, cells: this.cellsOf(this.run.atoms) }, true), { start, shown: this.shown });
    }

    cellsOf(atoms) {
        return Math.cbrt(atoms / 4);
    }

    setControls(controls) {
        this.controls = controls;
        this.known.controls = controls;
        this.sliders.show(controls);
        return this.nameState(controls);
    }

    /** After a deck was opened as text, the sliders show its state as far as they can. */
    readControls() {
        if (this.run.kind !== "fluid") return;
        const stage = this.run.stages.at(-1);
        const temperature = this.run.stages.map((each) => each.temperature).filter((each) => each !== null).at(-1) ?? this.controls.temperature;
        this.setControls({ ...this.controls, film: false, density: Number(this.run.density.toPrecision(4)), temperature, timeStep: stage.time_step });
    }

    /** While a slider moves the last place counts: naming a state takes longer than a slider needs to the next one. */
    nameStateSoon(values) {
        const isUnderWay = this.unnamed !== undefined;
        this.unnamed = values;
        if (isUnderWay) return;
        this.guard(async () => {
            while (this.unnamed !== undefined) {
                const wanted = this.unnamed;
                await this.nameState(wanted);
                if (this.unnamed === wanted) this.unnamed = undefined;
            }
        });
    }

    async nameState({ temperature, density }) {
        const state = await this.client.call("state", { temperature, density });
        this.sliders.name(state);
        this.isFluid = state.fluid;
    }

    isFull() {
        return this.run?.kind === "fluid" && /truncation\s*=\s*"cut"/.test(this.texts.deck.value) && /tail\s*=\s*true/.test(this.texts.deck.value) && !this.controls.film;
    }

    // Time.

    async step() {
        this.transport.pause();
        this.take(await this.client.call("advance", { steps: 1, shown: true }));
        await this.look();
    }

    /** Takes so many steps without pictures. */
    async compute(steps) {
        for (let done = 0; done < steps; done += SLICE) {
            this.transport.rate.textContent = word("computing", { steps: number(steps) });
            this.take(await this.client.call("advance", { steps: Math.min(SLICE, steps - done) }));
        }
    }

    /** Turns the motion round. A run that cannot go back to the last bit becomes one that can first. */
    async reverse() {
        const atoms = { ...this.controls, atoms: this.run.atoms, cells: this.cellsOf(this.run.atoms) };
        const isReversible = this.run.stages.length === 2 && this.run.stages[1].reverse;
        const { step } = this.state;
        if (!isReversible) {
            const start = await this.client.call("configuration");
            this.setControls({ ...this.controls, held: false });
            await this.open(reversalDeck(atoms, true, 100000), { start, about: "about reversible" });
            return;
        }
        if (step === 0 || step > this.run.stages[0].steps) return;
        this.transport.pause();
        const flip = this.flipAfter(step, this.run.stages[0].time_step);
        await this.open(reversalDeck(atoms, this.start !== null, step), { start: this.start, shown: this.shown, about: "about reversal", flip, playing: false });
        await this.compute(step);
        this.transport.play();
    }

    /** Pictures come in their order, and so states are taken. */
    show(frame) {
        if (frame.serial !== this.run.serial) return;   // of a run that is gone
        this.take(frame);
        this.transport.count(frame.steps);
        if (frame.finished && this.transport.playing) {
            this.transport.pause();
            this.guard(() => this.end());
        }
        this.picture.show(frame);
    }

    take(state) {
        this.state = state;
        this.transport.finished = state.finished;
        for (const row of state.rows) this.known.rows.push(row);
        // Of old samples fewer are kept: a chart has room for some hundreds, and a run may last for hours.
        if (this.known.rows.length > MOST_ROWS) this.known.rows = this.known.rows.filter((_, place, all) => place > all.length / 2 || place % 2 === 0);
        const total = this.run.steps;
        this.stateWords.textContent = word("state", { time: number(Number(state.time.toPrecision(6)), 6), unit: this.run.kind === "fluid" ? "τ" : "", step: number(state.step),
            of: total < 1e6 ? ` / ${number(total)}` : "", stage: state.finished ? word("finished") : state.stage });
    }

    /** Looks at the averages, the tables, the speeds; draws a chart. */
    async look() {
        this.transport.showRate();
        if (!this.run || this.looking || !this.state) return;
        this.looking = true;
        const { serial } = this.run;
        try {
            if (this.lookedAt === this.state) return;
            this.lookedAt = this.state;
            const { results, tables } = await this.client.call("result");
            if (serial !== this.run.serial) return;
            this.known.results = results;
            this.known.tables = tables;
            if (this.run.kind === "fluid") {
                this.known.speeds = await this.client.call("speeds");
                const temperature = results.observables?.temperature?.mean;
                const equation = temperature > 0 && this.isFull() && this.isFluid ? await this.client.call("equation", { temperature, density: this.run.density }) : null;
                this.numbers.update(results, equation, this.controls);
            }
            if (this.transport.playing) {
                this.charts.updateNext(this.known);
                this.charts.updateNext(this.known);
            } else {
                this.charts.update(this.known);
            }
            if (!this.transport.playing && !(this.flipped >= 0)) {
                const { step, checksum } = await this.client.call("checksum");
                if (serial === this.run.serial) this.texts.check(this.run.stages, step, checksum);
            }
        } catch (error) {
            if (error.kind === undefined) throw error;  // a run that has failed has no results; it was told why
        } finally {
            this.looking = false;
        }
    }

    async end() {
        await this.look();
        const stages = this.known.results?.stages ?? [];
        if (this.run.stages.length === 2 && this.run.stages[1]?.reverse && stages.length === 2) {
            const same = stages[0].checksum_at_start === stages[1].checksum_at_end;
            this.verdict.hidden = false;
            this.verdict.textContent = word(same ? "back" : "not back");
            this.verdict.classList.toggle("good", same);
        }
        this.charts.update(this.known);
    }

    stop(error) {
        this.transport.pause();
        this.transport.finished = true;
        this.complain(word("blown up"), error.message, error.kind === "physics" ? word("blow up words") : "");
    }

    complain(title, message, words = "") {
        this.trouble.hidden = false;
        this.trouble.replaceChildren(element("strong", {}, title), element("pre", {}, message), words ? element("p", {}, words) : "");
    }

    async verify() {
        this.transport.pause();
        this.texts.digits.textContent = word("digits running");
        this.texts.tellDigits(await this.client.call("verify"), this.version.version);
    }

    /** Does what the reader asked for, one after the other, and tells what the engine had to say against it. */
    guard(act) {
        this.opening = this.opening.then(act).catch((error) => {
            if (error.kind === undefined) throw error;
            if (error.kind === "physics") this.stop(error);
            else if (act === this.ofText) this.texts.complain(error.message);
            else this.complain(word("mistakes"), error.message);
        });
        return this.opening;
    }
}
