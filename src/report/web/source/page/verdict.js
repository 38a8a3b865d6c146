// The head of the page: what it is, how it ended, and the verdict in words.
import { element, section } from "../dom.js";
import { pretty } from "../format.js";

const LEVELS = {
    good: { sign: "✓", words: "good" },
    doubt: { sign: "!", words: "in doubt" },
    bad: { sign: "✕", words: "bad" },
    unknown: { sign: "?", words: "not known" },
};
const ORDER = ["good", "unknown", "doubt", "bad"];
const KINDS = {
    run: "Molecular dynamics run", "few-body": "Few bodies", sweep: "Sweep", reference: "Reference values", reproduction: "Reproduction",
    comparison: "Comparison", set: "Runs compared",
};

const known = (level) => (Object.hasOwn(LEVELS, level) ? level : "unknown");

/** A round sign with a shape of its own, so that colour is not all that tells. */
export function levelSign(level) {
    const { sign, words } = LEVELS[known(level)];
    return element("span", { class: `sign ${known(level)}`, role: "img", "aria-label": words }, sign);
}

/** The worst level of a verdict. */
export function worst(verdict) {
    return verdict.map((entry) => known(entry.level)).reduce((a, b) => (ORDER.indexOf(b) > ORDER.indexOf(a) ? b : a), "good");
}

export function pageHead(payload) {
    const state = payload.state ?? "";
    return element("div", { class: "hero" },
        element("p", { class: "kind" }, KINDS[payload.kind] ?? "Report",
            state && element("span", { class: `state ${/^[a-z]+$/.test(state) ? state : ""}` }, state)),
        element("h1", {}, element("bdi", {}, payload.title || payload.source || "ljmd report")),
        payload.state_words && element("p", { class: "state-words" }, pretty(payload.state_words)),
        payload.source && element("p", { class: "source" }, element("code", {}, element("bdi", {}, payload.source))));
}

export function verdictList(verdict) {
    return element("ul", { class: "verdict" }, verdict.map((entry) =>
        element("li", { class: known(entry.level) }, levelSign(entry.level),
            element("div", {}, entry.subject && element("strong", {}, entry.subject), element("p", {}, pretty(entry.words))))));
}

export function warningList(warnings) {
    return element("ul", { class: "warnings" }, warnings.map((text) => element("li", {}, pretty(text))));
}

/** The verdict and the warnings as a section; null where there are none. */
export function verdictSection(payload, level) {
    const verdict = payload.verdict ?? [];
    const warnings = payload.warnings ?? [];
    if (verdict.length + warnings.length === 0) return null;
    return section("Verdict", level, verdict.length > 0 && verdictList(verdict), warnings.length > 0 && warningList(warnings));
}
