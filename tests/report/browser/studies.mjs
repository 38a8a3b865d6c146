// Payloads of kinds that take long to compute, and of pages that went wrong: small, hostile, made here.

const base = (kind, hostile, more) => ({
    format: "ljmd-report", version: 1, kind, title: `${hostile}${kind}`, source: hostile, state: "finished",
    state_words: hostile, program: { version: hostile }, provenance: [[hostile, hostile]], warnings: [hostile],
    verdict: [{ subject: hostile, level: "doubt", words: hostile }], quantities: [], footnotes: [hostile],
    charts: [], tables: [], downloads: { deck: hostile, methods: hostile, bibtex: hostile }, ...more,
});

export function sweep(hostile) {
    const rows = [0.8, 1.2, 2].flatMap((temperature) => [0.1, 0.4, 0.8].map((density) => [temperature, density]));
    const failed = (row) => row === 1;
    const values = [rows.map(([temperature]) => temperature), rows.map(([, density]) => density),
        rows.map(([temperature, density], row) => (failed(row) ? null : temperature * density)),
        rows.map((_, row) => (failed(row) ? null : 0.01)), rows.map(() => hostile)];
    return base("sweep", hostile, {
        tables: [{ name: "points", title: hostile, file: "../../evil.csv", lead: true, values, columns: [
            { name: "temperature", label: "T", unit: "epsilon/k_B" }, { name: "density", label: "rho" }, { name: "pressure" },
            { name: "pressure_error", error_of: "pressure" }, { name: "note" }] }],
        charts: [
            { id: "map", title: hostile, lead: true, x: { label: "rho", scale: "category" }, y: { label: "T", scale: "category" },
                marks: [{ type: "cells", table: "points", x: "density", y: "temperature", fill: "pressure" }] },
            { id: "lines", title: "Isotherms", lead: true, x: { label: "rho" }, y: { label: "p" },
                marks: [{ type: "dots", table: "points", x: "density", y: "pressure", error: "pressure_error", group: "temperature" }] },
        ],
        points: rows.map((point, row) => ({ label: hostile, directory: hostile, href: failed(row) ? null : "javascript:window.broken=1//x",
            state: failed(row) ? "failed" : "finished", words: hostile })),
    });
}

export function reproduction(hostile) {
    const rows = Array.from({ length: 39 }, (_, row) => `${row} ${hostile}`);
    return base("reproduction", hostile, {
        tables: [{ name: "rows", title: "Rows", lead: true, flag: "suspect",
            columns: [{ name: "row" }, { name: "z" }, { name: "suspect" }],
            values: [rows, rows.map((_, row) => Math.sin(row) * 3.5), rows.map((_, row) => row === 7)] }],
        charts: [{ id: "z", title: "Differences", lead: true, x: { label: "z" }, y: { label: "row", scale: "category" },
            marks: [{ type: "diverging-dots", table: "rows", x: "z", y: "row", flag: "suspect", label: hostile }] }],
    });
}

export function comparison(hostile) {
    return base("comparison", hostile, {
        tables: [{ name: "checks", title: "Checks", columns: [{ name: "check" }, { name: "found" }, { name: "tolerance" }],
            values: [["energy", "force"], [1e-13, 0], [1e-10, 1e-8]] }],
        charts: [{ id: "checks", title: "Checks", lead: true, x: { label: "difference", scale: "log" }, y: { label: "check", scale: "category" },
            marks: [{ type: "dots", table: "checks", x: "found", y: "check", label: "found" },
                { type: "dots", table: "checks", x: "tolerance", y: "check", label: "tolerance", open: true, colour: 1 }] }],
    });
}

/** What is left of a run that was cut off: no whole frame, empty tables, names of tables that are not there. */
/** Two runs of few bodies: each has a history, and one turning point, a single dot that is no chart. */
export function dots(hostile) {
    const run = (shift) => base("few-body", hostile, {
        tables: [{ name: "history", title: "History", columns: [{ name: "time" }, { name: "energy" }], values: [[0, 1, 2], [shift, 1, 2]] },
            { name: "turns", title: "Turns", columns: [{ name: "time" }, { name: "distance" }], values: [[1], [shift]] }],
        charts: [
            { id: "energy", title: "Energy", x: { label: "t" }, y: { label: "E" }, marks: [{ type: "line", table: "history", x: "time", y: "energy" }] },
            { id: "turns", title: "Turns", x: { label: "t" }, y: { label: "r" }, marks: [{ type: "dots", table: "turns", x: "time", y: "distance" }] }],
    });
    return base("set", hostile, { members: [1, 2].map((shift) => ({ label: `run ${shift}`, payload: run(shift) })) });
}

export function damaged(hostile) {
    return base("run", hostile, {
        state: "damaged", quantities: [{ name: "pressure", value: null, error: null, text: "no value", mark: "[1]" }],
        atoms: { atoms: 100, frames: 1, box: [[1, 1, 1]], positions: "AAAA", colours: [] },
        tracks: { bodies: [], times: [], positions: "" },
        tables: [{ name: "empty", columns: [{ name: "time" }], values: [[]] }],
        charts: [{ id: "none", title: "Nothing", x: { label: "t / tau" }, y: {}, marks: [{ type: "line", table: "gone", x: "time", y: "y" },
            { type: "unheard-of", table: "empty" }, { type: "line", table: "empty", x: "time", y: "time" }] }],
    });
}

/** A random fluid that is too large for a quick picture. */
export function large(hostile, count = 32000, frames = 4) {
    const positions = Buffer.alloc(frames * count * 6);
    let state = 1;
    for (let place = 0; place < positions.length; place += 2) {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        positions.writeUInt16LE(state >>> 16, place);
    }
    return base("run", hostile, {
        atoms: { atoms: count, shown_atoms: count, frames: 1000, shown_frames: frames, words: "4 of 1000 frames are shown.", times: [0, 1, 2, 3],
            steps: [0, 1, 2, 3], box: [[34, 34, 34]], positions: positions.toString("base64"), colours: [] },
    });
}
