// A run on the page: what is opened, how it goes on, what is shown of it.
import { element } from "../../../report/web/source/dom.js";
import { number } from "../../../report/web/source/format.js";
import { Controls } from "./controls.js";
import { fluidDeck, reversalDeck, START } from "./decks.js";
import { Exercises } from "./exercises.js";
import { LiveAtoms } from "./live_atoms.js";
import { LiveBodies } from "./live_bodies.js";
import { LiveCharts } from "./live_charts.js";
import { Numbers } from "./numbers.js";
import { FEW_BODIES, FLUIDS } from "./scenes.js";
import { START_FILE, Texts } from "./texts.js";
import { Transport } from "./transport.js";
import { word } from "./words.js";

const KNOW = 700;       // milliseconds between looks at the averages
const MOST_ROWS = 6000;
const SLICE = 500;      // steps that are computed at once where nobody looks

/* global ljmdFewBodies, ljmdDiagram: decks of inputs/fewbody by name, and lines of the phase diagram; put here by build.mjs */

export class Page {
    constructor(client, version) {
        this.client = client;
        this.version = version;
        this.controls = { ...START };
        this.known = { rows: [], tables: [], place: {}, fluid: null, controls: this.controls, diagram: ljmdDiagram };
        this.opening = Promise.resolve();
        this.layout();
        client.on("frame", (frame) => this.show(frame));
        client.on("stopped", (error) => this.stop(error));
        setInterval(() => this.look(), KNOW);
    }

    layout() {
        const button = (name, act, more = {}) => element("button", { type: "button", class: "small", onclick: act, ...more }, word(name));
        this.transport = new Transport(this.client, () => this.guard(() => this.step()));
        this.texts = new Texts({
            run: () => this.guard(() => this.openText()), link: () => this.guard(() => this.texts.copyLink()), verify: () => this.guard(() => this.verify()),
        });
        this.flip = element("input", { type: "checkbox" });
        this.reverseButton = button("reverse", () => this.guard(() => this.reverse()));
        this.stateWords = element("p", { class: "time" });
        this.about = element("p", { class: "about" });
        this.verdict = element("p", { class: "verdict-line", role: "status", hidden: true });
        this.trouble = element("div", { class: "trouble", role: "alert", hidden: true });
        this.place = element("div", { class: "picture" });
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
                element("section", { class: "viewer", "aria-label": word("atoms label") }, this.about, this.place,
                    this.transport.node,
                    element("div", { class: "controls" }, this.stateWords, button("again", () => this.guard(() => this.again())), this.reverseButton,
                        element("label", { class: "check" }, this.flip, ` ${word("flip")}`), button("reset view", () => this.viewer?.resetView())),
                    this.verdict, this.trouble, this.transport.rate),
                element("div", { class: "side" }, this.sliders.node, this.numbers.node)),
            element("section", { "aria-labelledby": "charts" }, element("h2", { id: "charts" }, word("charts")), this.charts.node),
            element("section", { class: "texts" }, this.texts.deckPart, this.texts.homePart, this.exercises.node));
    }

    // What is run.

    /** Opens a deck. @param {object} how `start`: the text of its start file; `shown`: name of the scene */
    async open(deck, { start = null, shown = null, about = null, force = false, flip = -1, playing = true, name = "page.toml" } = {}) {
        this.transport.pause();
        this.trouble.hidden = this.texts.messages.hidden = this.verdict.hidden = true;
        const run = await this.client.call("open", { name, deck, settings: [], force, files: start ? { [START_FILE]: start } : {}, flip });
        this.run = run;
        this.start = start;
        this.shown = shown;
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
        this.renewViewer(run);
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

    renewViewer(run) {
        const same = run.kind === "fluid" && this.viewer instanceof LiveAtoms && this.viewer.count === run.atoms &&
            run.edges.every((edge, axis) => Math.abs(edge / this.viewer.box[axis] - 1) < 0.2);
        if (same) return;
        this.viewer?.close();
        this.viewer = run.kind === "fluid" ? new LiveAtoms(run.atoms, run.edges) : new LiveBodies(run);
        this.place.replaceChildren(this.viewer.node);
    }

    async openScene(name) {
        const { from, reversal, ...controls } = FLUIDS[name];
        this.setControls(controls);
        if (reversal) {
            this.there = reversal;
            await this.open(reversalDeck(controls, false, reversal), { shown: name });
            return;
        }
        let start = null;
        if (from) {
            // From a hotter fluid, made at once.
            await this.open(fluidDeck({ ...controls, ...from, equilibration: 300, production: 100, measured: false }, false), { shown: name, playing: false });
            await this.compute(300);
            start = await this.client.call("configuration");
        }
        await this.open(fluidDeck({ ...controls, atoms: this.run?.atoms }, start !== null), { start, shown: name });
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
        await this.open(this.texts.deck.value, { start: this.start, shown: this.shown, force: this.texts.force.checked });
    }

    /** A slider was let go: the atoms go on from where they are, or anew when their number changes. */
    async change(key, value) {
        const controls = { ...this.controls, [key]: value, equilibration: 500 };
        if (key === "density" && controls.film) controls.film = false;
        this.setControls(controls);
        if (key === "cells" || this.run?.kind !== "fluid" || controls.film) {
            await this.open(fluidDeck(controls, false), { shown: this.shown });
            return;
        }
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
        this.phase = state.phase;
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
            await this.open(reversalDeck(atoms, true, 100000), { start, about: "about reversal" });
            return;
        }
        if (step === 0 || step > this.run.stages[0].steps) return;
        const timeStep = this.run.stages[0].time_step;
        const flip = this.flip.checked ? (step + Math.ceil(step / 20)) * timeStep : -1;
        await this.open(reversalDeck(atoms, this.start !== null, step), { start: this.start, shown: this.shown, about: "about reversal", flip, playing: false });
        await this.compute(step);
        this.transport.play();
    }

    /** Shows a picture as soon as the one before is drawn; the next one is computed while this one is. */
    show(frame) {
        const now = () => {
            if (frame.serial !== this.run.serial) return;
            if (!document.hidden && this.viewer.busy) {
                setTimeout(now, 2);
                return;
            }
            this.client.command("drawn");
            this.take(frame);
            if (!document.hidden) this.viewer.show(frame);
            this.transport.count(frame.steps);
            if (frame.finished && this.transport.playing) {
                this.transport.pause();
                this.guard(() => this.end());
            }
        };
        if (document.hidden) now();     // nothing is drawn in the background, and the run goes on
        else requestAnimationFrame(now);
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
        try {
            if (this.lookedAt === this.state) return;
            this.lookedAt = this.state;
            const { results, tables } = await this.client.call("result");
            this.known.results = results;
            this.known.tables = tables;
            if (this.run.kind === "fluid") {
                this.known.speeds = await this.client.call("speeds");
                const temperature = results.observables?.temperature?.mean;
                const equation = temperature > 0 && this.isFull() && this.phase !== "solid" && this.phase !== "two phases" ? await this.client.call("equation", { temperature, density: this.run.density }) : null;
                this.numbers.update(results, equation, this.controls);
            }
            if (this.transport.playing) {
                this.charts.updateNext(this.known);
                this.charts.updateNext(this.known);
            } else {
                this.charts.update(this.known);
            }
            if (!this.transport.playing && !(this.flipped >= 0)) this.texts.check(this.run.stages, this.state.step, await this.client.call("checksum"));
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
            this.transport.pause();
            if (error.kind === "physics") {
                this.stop(error);
                return;
            }
            this.texts.complain(error.message);
        });
        return this.opening;
    }
}
