// Sliders of the state. While one moves, the state is named; when it is let go, the run changes.
import { element, uniqueId } from "../../../report/web/source/dom.js";
import { number, withSubscripts } from "../../../report/web/source/format.js";
import { LIMITS, SIZES } from "./decks.js";
import { word } from "./words.js";

function slider(name, key, unit) {
    const id = uniqueId(key);
    const input = element("input", { id, type: "range", ...LIMITS[key] });
    const output = element("output", { for: id });
    const label = element("label", { for: id }, withSubscripts(word(name)));
    const row = element("div", { class: `slider of-${key}` }, label, output, input);
    return { row, input, label, show: (value = Number(input.value)) => {
        output.textContent = `${number(value, 4)}${unit ? ` ${unit}` : ""}`;
        input.setAttribute("aria-valuetext", output.textContent);
    } };
}

export class Controls {
    /** @param {{moved: Function, changed: (key: string, value: unknown) => void}} calls */
    constructor({ moved, changed }) {
        this.sliders = { temperature: slider("temperature", "temperature", "ε/k"), density: slider("density", "density", "σ⁻³"), timeStep: slider("time step", "timeStep", "τ"), cutoff: slider("cutoff", "cutoff", "σ") };
        for (const [key, { input, show }] of Object.entries(this.sliders)) {
            input.addEventListener("input", () => {
                show();
                moved(this.read());
            });
            input.addEventListener("change", () => changed(key, Number(input.value)));
        }
        this.size = element("select", { id: uniqueId("size") }, SIZES.map((cells) => element("option", { value: cells }, number(4 * cells ** 3))));
        this.size.addEventListener("change", () => changed("cells", Number(this.size.value)));
        this.held = element("input", { type: "checkbox" });
        this.held.addEventListener("change", () => changed("held", this.held.checked));
        this.words = element("p", { class: "state-of-fluid", role: "status" });
        this.node = element("section", { class: "card", "aria-labelledby": "controls" }, element("h2", { id: "controls" }, word("controls")),
            this.sliders.temperature.row, this.sliders.density.row, this.words, this.sliders.timeStep.row, this.sliders.cutoff.row,
            element("div", { class: "slider of-size" }, element("label", { for: this.size.id }, word("size")), this.size),
            element("label", { class: "check" }, this.held, ` ${word("hold")}`));
    }

    read() {
        const values = Object.fromEntries(Object.entries(this.sliders).map(([key, { input }]) => [key, Number(input.value)]));
        return { ...values, cells: Number(this.size.value), held: this.held.checked };
    }

    show(controls) {
        for (const [key, { input, show }] of Object.entries(this.sliders)) {
            if (document.activeElement === input && input.matches(":active")) continue;
            input.value = controls[key] ?? input.value;
            show(controls[key]);    // a slider has steps
        }
        this.size.value = controls.cells;
        this.held.checked = controls.held;
        this.startsThere = !controls.held && controls.equilibration === 0;   // the run goes on to a temperature of its own
        this.sliders.temperature.label.textContent = word(this.startsThere ? "temperature at first" : "temperature");
    }

    /** @param {object} state what the engine says of the state */
    name(state) {
        if (this.startsThere) {
            this.words.textContent = word("own temperature");
            return;
        }
        const phase = state.phase === null ? null : state.phase[0].toUpperCase() + state.phase.slice(1);
        this.words.textContent = phase === null ? word("far below") : word(state.stable ? "stable lines" : "not stable", { phase, lines: state.lines ? `${state.lines[0].toUpperCase()}${state.lines.slice(1)}.` : "" });
        this.words.classList.toggle("unsure", !state.stable);
    }
}
