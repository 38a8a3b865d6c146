// Two exercises of the class kit; what counts as right comes from the run that is on the page.
import { element, uniqueId } from "../../../report/web/source/dom.js";
import { number, withError } from "../../../report/web/source/format.js";
import { word } from "./words.js";

/** The most probable speed at the mean temperature of the run. */
function likelySpeed(results) {
    const temperature = results?.observables?.temperature;
    if (!(temperature?.mean > 0)) return null;
    const value = Math.sqrt(2 * temperature.mean);
    return { value, error: (0.5 * value * (temperature.standard_error ?? 0)) / temperature.mean, allowed: 0.05 };
}

function neighbours(results) {
    const found = results?.observables?.coordination_number;
    return found?.mean > 0 ? { value: found.mean, error: found.standard_error, allowed: 0.05 } : null;
}

export class Exercises {
    /** @param {() => object|null} results of the run as it stands */
    constructor(results) {
        this.node = element("section", { class: "card", "aria-labelledby": "exercises" }, element("h2", { id: "exercises" }, word("exercises")),
            this.exercise("exercise speeds", () => likelySpeed(results())), this.exercise("exercise neighbours", () => neighbours(results())));
    }

    exercise(question, answer) {
        const id = uniqueId(question);
        const field = element("input", { id, type: "text", inputmode: "decimal", autocomplete: "off" });
        const words = element("p", { role: "status" });
        const check = () => {
            const given = field.value.trim() === "" ? NaN : Number(field.value.trim().replace(",", "."));
            const right = answer();
            words.classList.remove("right");
            if (!Number.isFinite(given)) words.textContent = word("not a number");
            else if (right === null) words.textContent = word("no answer yet");
            else {
                const off = (given - right.value) / right.value;
                const isRight = Math.abs(off) <= right.allowed + (3 * (right.error ?? 0)) / right.value;
                words.classList.toggle("right", isRight);
                words.textContent = isRight ? word("right", { value: withError(right.value, right.error), error: "" })
                    : word("nearly", { percent: number(Math.round(100 * Math.abs(off))), where: word(off < 0 ? "higher" : "lower") });
            }
        };
        field.addEventListener("keydown", (event) => { if (event.key === "Enter") check(); });
        return element("div", { class: "exercise" }, element("label", { for: id }, word(question)),
            element("div", { class: "answer" }, field, element("button", { type: "button", class: "small", onclick: check }, word("check answer"))), words);
    }
}
