// ljmd for other pages: `import { Simulation } from "./ljmd.mjs"`. See ljmd.d.ts.
import { EngineError, makeEngine } from "./engine.js";

/* global ljmdEngine, ljmdPacked: the compiled engine, put before this by build.mjs */

export { EngineError };

async function unpacked() {
    const bytes = Uint8Array.from(atob(ljmdPacked), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).arrayBuffer();
}

let engine = null;  // unpacked once

export class Simulation {
    #engine;
    #samples = [];
    #state;

    constructor(made, description) {
        this.#engine = made;
        this.description = description;
        this.#take(0);
    }

    static async open(deck, { settings = [], files = {}, force = false, name = "deck.toml" } = {}) {
        engine ??= await unpacked();
        const made = await makeEngine(ljmdEngine, engine);
        return new Simulation(made, made.call({ call: "open", name, deck, settings, files, force }));
    }

    #take(steps) {
        this.#state = this.#engine.call({ call: "advance", steps });
        const { columns } = this.description;
        for (const row of this.#state.rows) this.#samples.push(Object.fromEntries(columns.map((column, place) => [column, row[place]])));
    }

    advance(steps) {
        this.#take(steps);
        return this;
    }

    get step() { return this.#state.step; }
    get time() { return this.#state.time; }
    get finished() { return this.#state.finished; }
    get edges() { return this.#state.edges ?? null; }
    get samples() { return this.#samples; }
    get checksum() { return this.#engine.call({ call: "checksum" }).checksum; }

    result() {
        const { results, text, tables } = this.#engine.call({ call: "result" });
        return { ...results, text, tables: Object.fromEntries(tables.map((table) => [table.name, Object.fromEntries(table.columns.map((column, place) => [column, table.values[place]]))])) };
    }

    positions() {
        if (this.description.kind !== "fluid") return this.#state.bodies;
        const { positions } = this.#engine.picture(this.description.atoms);
        return Array.from({ length: this.description.atoms }, (_, atom) => [0, 1, 2].map((axis) => (positions[3 * atom + axis] / 65536) * this.edges[axis]));
    }
}
