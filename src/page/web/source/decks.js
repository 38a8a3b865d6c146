// Decks, made from what the controls say. They are what `ljmd run` takes; the page has no other way to say what is run.
import { word } from "./words.js";

export const LIMITS = {
    temperature: { min: 0.3, max: 5, step: 0.01 },
    density: { min: 0.02, max: 1.15, step: 0.002 },
    timeStep: { min: 0.001, max: 0.02, step: 0.001 },
    cutoff: { min: 1.2, max: 4, step: 0.1 },
};
export const SIZES = [3, 4, 5, 6, 8, 10];   // cells of the crystal along an edge; four atoms each

export const START = {
    scene: "liquid", temperature: 0.85, density: 0.8442, timeStep: 0.004, cutoff: 2.5, cells: 6, held: true,
    equilibration: 1000, film: false, seed: 1967,
};

const CANONICAL = '{ type = "stochastic-rescaling", time = 0.5 }';
const FRICTION = '{ type = "langevin", time = 0.5 }';

const number = (value) => (Number.isInteger(value) ? `${value}.0` : String(Number(value.toPrecision(12))));

/** The largest cutoff that the box of a crystal has room for. */
export function largestCutoff({ cells, density, film }) {
    const edge = cells * Math.cbrt(4 / (film ? 0.79 : density));
    return Math.floor(10 * (edge / 2)) / 10;
}

function start(controls, kept) {
    if (kept) {
        const density = controls.density === null ? "" : `density = ${number(controls.density)}\n`;
        return `file = "start.xyz"                  # the atoms as they were, with their velocities\n${density}`;
    }
    if (controls.film) {
        // A slab of liquid in a box four times as high as wide.
        return `lattice = { type = "fcc", cells = ${controls.cells}, layers = ${controls.cells + 3}, height = ${number(Math.round(4 * controls.cells * Math.cbrt(4 / 0.79)))} }
density = 0.79
`;
    }
    return `lattice = { type = "fcc", cells = ${controls.cells} }   # ${4 * controls.cells ** 3} atoms
density = ${number(controls.density)}
`;
}

/** A stage as text. */
function stageText({ name, steps, timeStep, temperature, thermostat, sample }) {
    return `[[stage]]
name = "${name}"
time_step = ${number(timeStep)}
steps = ${steps}
${thermostat ? `temperature = ${number(temperature)}\nthermostat = ${thermostat}` : "# constant energy"}
${sample ? "sample = true\n" : ""}
`;
}

/** The stages of a deck that this module has made, for {@link fluidDeck}; undefined for another deck. */
export function pastOf(deck) {
    const texts = deck.split("[[stage]]\n").slice(1);
    const found = texts.map((text) => {
        const value = (key) => new RegExp(`^${key} = (.*?)\\s*$`, "m").exec(text)?.[1];
        return { name: value("name")?.slice(1, -1), timeStep: Number(value("time_step")), temperature: Number(value("temperature")), thermostat: value("thermostat") };
    });
    const wasMade = found.length > 0 && deck.includes('directory = "runs/from-the-page"') &&
        found.every((stage) => stage.name && stage.timeStep > 0 && (!stage.thermostat || stage.temperature > 0));
    return wasMade ? found : undefined;
}

/**
 * The deck of a fluid.
 * @param {object} controls see {@link START}
 * @param {boolean} kept whether it starts from start.xyz
 * @param {object[]} past stages that it begins with, see {@link pastOf}, with their steps
 */
export function fluidDeck(controls, kept, past = []) {
    const cutoff = number(Math.min(controls.cutoff, largestCutoff(controls)));
    const stages = past.map((stage, place) => ({ ...stage, name: `stage-${place + 1}` }));
    if (controls.equilibration > 0) {
        stages.push({ name: "equilibration", steps: controls.equilibration, timeStep: controls.timeStep, temperature: controls.temperature, thermostat: FRICTION });
    }
    stages.push({ name: "production", steps: controls.production ?? 2000000, timeStep: controls.timeStep, temperature: controls.temperature,
        thermostat: controls.held ? CANONICAL : null, sample: true });
    // Velocities are drawn for the first stage, unless a file has them.
    const drawn = kept ? "" : `temperature = ${number(past[0]?.temperature || controls.temperature)}\n`;
    return `title = "${word("deck title", { atoms: controls.atoms ?? 4 * controls.cells ** 2 * (controls.cells + (controls.film ? 3 : 0)), temperature: number(controls.temperature) })}"

[system]
${start(controls, kept)}${drawn}seed = ${controls.seed}

[potential]
type = "lennard-jones"
cutoff = ${cutoff}
${controls.film ? 'truncation = "shifted"' : 'truncation = "cut"\ntail = true                             # what is cut off is corrected for'}

${stages.map(stageText).join("")}[output]
directory = "runs/from-the-page"
thermo = { every = 10 }
${analyses(controls)}`;
}

function analyses(controls) {
    if (controls.measured === false) return "";
    return `
[analysis]
${controls.film ? "film = { layers = 120, every = 20 }" : `rdf = { bins = 120, every = 40 }
structure_factor = { every = 200 }
msd = { every = 10, max_time = 4.0, origins = 20 }`}
`;
}

/** There and back: the reversible integrator, so many steps forward and as many back. */
export function reversalDeck(controls, kept, steps) {
    return `title = "${word("reversal title", { steps })}"

[system]
${start(controls, kept)}${kept ? "" : `temperature = ${number(controls.temperature)}\n`}seed = ${controls.seed}

[potential]
type = "lennard-jones"
cutoff = ${number(Math.min(controls.cutoff, largestCutoff(controls)))}
truncation = "cut"
tail = false

[[stage]]
name = "there"
integrator = "bit-reversible"
time_step = ${number(controls.timeStep)}
steps = ${steps}
sample = true

[[stage]]
name = "back"
integrator = "bit-reversible"
time_step = ${number(controls.timeStep)}
steps = ${steps}
reverse = true

[output]
directory = "runs/there-and-back"
thermo = { every = 5 }
`;
}
