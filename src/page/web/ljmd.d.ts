/** The engine of ljmd in a page or in node: `import { Simulation } from "./ljmd.mjs"`. All in the units of the deck's run. */

/** What the engine has against a deck or a run; the message is that of `ljmd run`. */
export class EngineError extends Error {
    readonly kind: "input" | "data" | "physics" | "memory" | "other";
}

export interface Description {
    kind: "fluid" | "few-body";
    title: string;
    atoms: number;
    steps: number;
    columns: string[];
    stages: { name: string; steps: number; time_step: number; sample: boolean; reverse: boolean; temperature: number | null }[];
    warnings: string[];
    edges?: [number, number, number];
    density?: number;
    masses?: number[];
}

export interface Options {
    settings?: string[];            // as `--set` takes them: "stage.production.steps=100"
    files?: Record<string, string>; // what the deck may start from: {"start.xyz": text}
    force?: boolean;                // run a deck with unlikely values, too
    name?: string;                  // of the deck, in messages
}

/** A run in memory. It computes where it is called: in a Worker the page stays free. */
export class Simulation {
    /** @throws EngineError with all mistakes of the deck */
    static open(deck: string, options?: Options): Promise<Simulation>;
    readonly description: Description;
    /** Take some steps; fewer if the run ends before. @throws EngineError of kind "physics" when the run blows up */
    advance(steps: number): this;
    readonly step: number;
    readonly time: number;
    readonly finished: boolean;
    readonly edges: [number, number, number] | null;
    /** All samples since the start, by column: step, time, temperature, potential_energy, pressure, ... */
    readonly samples: Record<string, number | null>[];
    /** Of the positions, as `ljmd run` prints it. */
    readonly checksum: string;
    /** results.json of the run so far, the report as text, and the tables of the analyses: tables.rdf.g */
    result(): { observables: Record<string, { mean: number | null; standard_error: number | null; unit: string }>; text: string; tables: Record<string, Record<string, number[]>>; [more: string]: unknown };
    /** By atom [sigma]: in the box, to a part in 65536 of its edges; of few bodies exact. */
    positions(): [number, number, number][];
}
