// Numbers, units and labels as they are read on the page.

const SYMBOLS = {
    epsilon: "ε", sigma: "σ", tau: "τ", rho: "ρ", eta: "η", theta: "θ", phi: "φ", omega: "ω", lambda: "λ", delta: "δ",
    Delta: "Δ", sqrt: "√", pi: "π", mu: "μ", chi: "χ", gamma: "γ",
};
const RAISED = { 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹", "-": "⁻", "+": "⁺" };

const MINUS = "−";

/** `epsilon/sigma^3` as `ε/σ³`. Subscripts stay `_B`; {@link withSubscripts} and charts set them lower. */
export function pretty(label) {
    return String(label ?? "")
        .replace(/[A-Za-z]+/g, (word) => SYMBOLS[word] ?? word)
        .replace(/(<[^<>]*>)\^\(1\/2\)/g, "√$1")
        .replace(/\^([-+]?\d+)/g, (_, digits) => [...digits].map((digit) => RAISED[digit]).join(""))
        .replace(/ \+- /g, " ± ")
        .replace(/(^|[\s(:,])-(?=[\d.])/g, `$1${MINUS}`);
}

/** A pretty label cut at its subscripts: `ε/k_B` is [["ε/k", ""], ["", "B"]]. */
export function subscriptParts(label) {
    return [...pretty(label).matchAll(/([^_]*?)(?:(?<=[^\s_])_(\w+)|$)/g)].map((match) => [match[1], match[2] ?? ""])
        .filter(([plain, low]) => plain !== "" || low !== "");
}

/** The nodes of a label, with subscripts. */
export function withSubscripts(label) {
    return subscriptParts(label).flatMap(([plain, low]) => {
        if (low === "") return [document.createTextNode(plain)];
        const sub = document.createElement("sub");
        sub.textContent = low;
        return [document.createTextNode(plain), sub];
    });
}

/** A number with at most `digits` significant digits, without trailing zeros. */
export function number(value, digits = 6) {
    if (value === null || value === undefined || Number.isNaN(value)) return "–";
    if (typeof value !== "number") return String(value);
    if (Number.isInteger(value) && Math.abs(value) < 1e9) return grouped(String(value));
    const size = Math.abs(value);
    if (size !== 0 && (size >= 1e6 || size < 1e-4)) return power(value, digits);
    const text = value.toPrecision(digits);
    return text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "").replace("-", MINUS);
}

function power(value, digits) {
    const [mantissa, exponent] = value.toExponential(Math.min(digits, 4) - 1).split("e");
    const short = mantissa.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "").replace("-", MINUS);
    const times = short === "1" ? "" : `${short}×`;
    return `${times}10${[...String(Number(exponent))].map((digit) => RAISED[digit]).join("")}`;
}

/** 32000 as 32 000 with narrow spaces; four digits stay together. */
export function grouped(text) {
    const sign = text.startsWith("-") ? MINUS : "";
    const digits = text.replace("-", "");
    return sign + (digits.length < 5 ? digits : digits.replace(/\B(?=(\d{3})+$)/g, "\u202f"));
}

/** A value with its standard error: both to the second digit of the error. */
export function withError(value, error) {
    if (value === null || value === undefined) return "–";
    if (!(error > 0) || !Number.isFinite(error)) return number(value);
    const decimals = 1 - Math.floor(Math.log10(error));
    const size = Math.max(Math.abs(value), error);
    if (decimals > 9 || decimals < 0 || size >= 1e6) return `${number(value)} ± ${number(error, 2)}`;
    return `${value.toFixed(decimals)} ± ${error.toFixed(decimals)}`.replace("-", MINUS);
}
