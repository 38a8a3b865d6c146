// The texts of a run: its deck, what the engine has against it, and how the run goes on at home.
import { element } from "../../../report/web/source/dom.js";
import { number } from "../../../report/web/source/format.js";
import { copyButton, save } from "../../../report/web/source/save.js";
import { fragmentOf } from "./link.js";
import { word } from "./words.js";

export const START_FILE = "start.xyz";

export class Texts {
    /** @param {{run: Function, link: Function, verify: Function}} acts of the buttons */
    constructor(acts) {
        const button = (name, act) => element("button", { type: "button", class: "small", onclick: act }, word(name));
        this.deck = element("textarea", { rows: 24, spellcheck: "false", autocapitalize: "off", "aria-label": word("deck placeholder") });
        this.force = element("input", { type: "checkbox" });
        this.messages = element("pre", { class: "messages", role: "alert", hidden: true, tabindex: 0 });
        this.remarks = element("ul", { class: "warnings" });
        this.command = element("code");
        this.homeWords = element("p");
        this.checkWords = element("p", { class: "caption" });
        this.checksum = element("code", { class: "checksum" });
        this.saveStart = button("save start", () => save(START_FILE, this.start));
        this.link = button("link", acts.link);
        this.digits = element("p", { role: "status" });
        const run = button("run deck", acts.run);
        run.classList.add("main");
        this.deckPart = element("section", { class: "card", "aria-labelledby": "deck" }, element("h2", { id: "deck" }, word("deck")),
            element("p", { class: "caption" }, word("deck words")), this.deck, this.messages, this.remarks,
            element("div", { class: "buttons" }, run, element("label", { class: "check" }, this.force, ` ${word("force")}`)));
        this.homePart = element("section", { class: "card", "aria-labelledby": "home" }, element("h2", { id: "home" }, word("home")),
            this.homeWords, element("pre", {}, this.command), this.checkWords, element("p", {}, this.checksum),
            element("div", { class: "buttons" }, copyButton(word("copy"), this.command), button("save deck", () => save("page.toml", this.deck.value)),
                this.saveStart, this.link, button("digits", acts.verify)), this.digits);
    }

    complain(message) {
        this.messages.hidden = false;
        this.messages.textContent = message.replaceAll("--force runs it as it is", word("force words"));
        this.messages.scrollIntoView({ block: "nearest" });
    }

    /** A deck was opened. @param {string|null} start the file that it starts from */
    show(deck, start, force, warnings) {
        this.deck.value = deck;
        this.start = start;
        this.force.checked = force;
        this.remarks.replaceChildren(...warnings.map((text) => element("li", {}, text)));
        this.homeWords.textContent = word("home words", { start: start ? word("home start") : "" });
        this.command.textContent = "ljmd run page.toml";
        this.saveStart.hidden = start === null;
        this.link.disabled = start !== null;
        this.link.title = start === null ? "" : word("link kept");
        this.checkWords.textContent = start === null ? "" : word("link kept");
        this.checksum.textContent = this.digits.textContent = "";
    }

    /** The command that runs as far as the page has come, and the checksum of there. */
    check(stages, step, checksum) {
        let left = step;
        const settings = stages.map((stage) => {
            const steps = Math.min(stage.steps, left);
            left -= steps;
            return steps === stage.steps ? "" : ` --set stage.${stage.name}.steps=${steps}`;
        });
        this.command.textContent = `ljmd run page.toml${settings.join("")}`;
        this.checkWords.textContent = word("home check", { step: number(step) });
        this.checksum.textContent = checksum;
    }

    async copyLink() {
        history.replaceState(null, "", await fragmentOf({ deck: this.deck.value, name: "link.toml" }));
        try {
            await navigator.clipboard.writeText(location.href);
            this.link.textContent = word("link copied");
        } catch {
            this.link.textContent = word("link shown");
        }
        setTimeout(() => (this.link.textContent = word("link")), 2500);
    }

    tellDigits(all, version) {
        const wrong = all.filter((one) => !one.right);
        this.digits.textContent = wrong.length === 0 ? word("digits right", { version })
            : word("digits wrong", { problems: wrong.map((one) => `${one.problem}: ${one.found}`).join(", ") });
    }
}
