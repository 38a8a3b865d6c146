// The table of averages: mean and error from the run, what the equation of state has, and the state in words.
import { element } from "../../../report/web/source/dom.js";
import { number, pretty, withError, withSubscripts } from "../../../report/web/source/format.js";
import { word } from "./words.js";

// Symbol, observable, and what the equation of state calls it.
const SHOWN = [["T", "temperature"], ["U", "potential_energy", "potential_energy"], ["p", "pressure", "pressure"], ["n_c", "coordination_number"], ["D", "diffusion"],
    ["γ", "surface_tension"], ["ρ_l", "liquid_density"], ["ρ_v", "vapour_density"]];
const ALWAYS = 3;

export class Numbers {
    constructor() {
        this.rows = SHOWN.map(([symbol], place) => {
            const cells = { mean: element("td"), equation: element("td") };
            const row = element("tr", { hidden: place >= ALWAYS }, element("th", { scope: "row" }, element("i", {}, withSubscripts(symbol)), element("span", { class: "unit" }, ` ${word(symbol)}`)), cells.mean, cells.equation);
            return { row, ...cells };
        });
        this.samples = element("p", { class: "caption" });
        this.node = element("section", { class: "card", "aria-labelledby": "numbers" },
            element("h2", { id: "numbers" }, word("numbers")),
            element("table", { class: "numbers" },
                element("thead", {}, element("tr", {}, [word("quantity"), word("mean"), word("equation")].map((text) => element("th", { scope: "col" }, text)))),
                element("tbody", {}, this.rows.map(({ row }) => row))),
            this.samples);
    }

    /**
     * @param {object|null} results results.json of the run so far
     * @param {object|null} state what the equation of state has at the mean temperature; null: it does not hold here
     * @param {object} controls the temperature that is set
     */
    update(results, state, controls) {
        const observables = results?.observables ?? {};
        let samples = null;
        for (const [place, [symbol, name, ofEquation]] of SHOWN.entries()) {
            const found = observables[name];
            const { row, mean, equation } = this.rows[place];
            row.hidden = place >= ALWAYS && !found;
            const known = found && found.mean !== null && found.mean !== undefined;
            mean.textContent = known ? withError(found.mean, found.standard_error) : word("unknown yet");
            mean.classList.toggle("unsure", Boolean(known && found.error_is_converged === false));
            const value = state?.[ofEquation];
            if (symbol === "T") equation.textContent = controls.held ? word("set", { value: number(controls.temperature, 4) }) : "";
            else if (place < ALWAYS) equation.textContent = Number.isFinite(value) ? pretty(number(value, 4)) : word("unknown yet");
            if (known && symbol !== "T") samples = Math.min(samples ?? Infinity, found.independent_samples ?? Infinity);
        }
        this.samples.textContent = samples === null ? word("not sampled")
            : word("mean of", { samples: Number.isFinite(samples) ? word("independent", { count: number(Math.round(samples)) }) : "" });
    }
}
