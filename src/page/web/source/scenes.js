// Scenes in one click: what the controls are set to, or a deck of few bodies as it stands in inputs/.
import { START } from "./decks.js";

const crystal = { density: 0.97, cells: 5 };

/** `from`: the scene goes on from the atoms as they are, if they are a fluid of homogeneous density. */
export const FLUIDS = {
    liquid: START,
    crystal: { ...START, ...crystal, temperature: 0.6, equilibration: 500 },
    melt: { ...START, ...crystal, temperature: 1.9, equilibration: 0, held: true },
    freeze: { ...START, density: 1.0, cells: 5, temperature: 0.45, equilibration: 1500, from: { temperature: 2.5 } },
    evaporate: { ...START, density: 0.06, cells: 5, temperature: 1.2, equilibration: 0 },
    bubble: { ...START, density: 0.62, cells: 6, temperature: 0.75, equilibration: 1000 },
    film: { ...START, cells: 5, film: true, temperature: 0.75, equilibration: 2000, cutoff: 2.5 },
    reversal: { ...START, temperature: 1.2, equilibration: 0, held: false, reversal: 1500 },
};

/** Names of decks in inputs/fewbody. */
export const FEW_BODIES = {
    comet: "kepler-leapfrog",
    "two bodies": "kepler-velocity-verlet",
    pendulum: "pendulum",
    "figure eight": "figure-eight",
    pythagorean: "pythagorean",
    "three bodies": "three-body",
};
