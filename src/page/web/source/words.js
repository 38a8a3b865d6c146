// All words of the page, in one file: translate this one, and nothing else.

export const WORDS = {
    "title": "Molecular dynamics in a page",
    "lead": "Argon as Verlet computed it in 1967, here and now: the engine of ljmd, its decks, its digits. Nothing leaves this page.",
    "deck title": "{atoms} atoms at T = {temperature}, from a page",
    "reversal title": "{steps} steps there and back, bit for bit",

    "scenes": "Scenes",
    "fluids": "Fluids", "few bodies": "Few bodies",
    "scene liquid": "Liquid", "scene crystal": "Crystal", "scene melt": "Melt", "scene freeze": "Freeze", "scene evaporate": "Evaporate",
    "scene bubble": "Bubble", "scene film": "Film", "scene reversal": "Reverse time",
    "scene comet": "Comet", "scene two bodies": "Two bodies", "scene pendulum": "Pendulum", "scene figure eight": "Figure eight",
    "scene pythagorean": "Pythagorean", "scene three bodies": "Three stars",
    "about liquid": "Verlet's liquid: 864 atoms that begin as a crystal, and melt at once.",
    "about crystal": "A crystal of 500 atoms below its melting line. Raise the temperature until it breaks.",
    "about melt": "A crystal at T = 1.9, far above its melting point: the order parameter falls to zero.",
    "about freeze": "A hot fluid, cooled below its freezing line: does it find a crystal, or stay a glass?",
    "about evaporate": "A crystal in a box that is much too large: it falls apart into a gas.",
    "about bubble": "A liquid stretched below its vapour pressure: holes open, and grow to a bubble.",
    "about film": "A liquid with its vapour above and below: its surface, and the surface tension.",
    "about reversal": "A crystal melts, then all velocities turn round. The integrator is exact: the crystal comes back, to the last bit. Flip one bit on the way, and it does not.",
    "sun": "sun",
    "about comet": "A comet around its sun, by leapfrog.",
    "about two bodies": "Two bodies of equal mass on long ellipses.",
    "about pendulum": "A pendulum, let go at 170 degrees.",
    "about figure eight": "Three bodies that chase each other on a figure of eight.",
    "about pythagorean": "Masses 3, 4 and 5 at rest on the corners of a triangle: near encounters until one escapes.",
    "about three bodies": "Three stars from random positions.",
    "about reversible": "From here on the motion is computed so that it can be turned round to the last bit. Let it go for a while, then press the button again.",
    "about deck": "Your own deck.",

    "play": "Play", "pause": "Pause", "step": "Step", "again": "From the start", "speed": "Speed", "full speed": "as fast as it goes",
    "steps a picture": "{steps} steps a picture", "one step a picture": "1 step a picture", "reverse": "Turn time round", "flip": "flip one bit on the way back",
    "state": "t = {time} {unit} · step {step}{of} · {stage}", "rate": "{rate} steps/s · {pictures} pictures/s",
    "finished": "finished", "computing": "computing {steps} steps …",
    "atoms label": "Atoms. Arrow keys turn, plus and minus zoom, 0 resets.",
    "no webgl": "The atoms cannot be turned here: {why}. This is a still picture.",
    "speed legend": "thermal speeds √(kT/m)", "box": "Box", "reset view": "Reset view",

    "controls": "State",
    "temperature": "Temperature T", "temperature at first": "Temperature T at the start", "own temperature": "At constant energy the run finds a temperature of its own: see the averages.",
    "density": "Density ρ", "time step": "Time step Δt", "size": "Atoms N", "cutoff": "Cutoff r_c",
    "hold": "Hold the temperature (canonical)",
    "phase gas": "gas", "stable": "{phase}: stable.", "not stable": "{phase}: not stable. {lines}", "stable lines": "{phase}. {lines}",
    "far below": "Far below the triple point, where no fluid is known.",

    "numbers": "Averages", "quantity": "quantity", "mean": "mean ± error", "equation": "equation of state", "unknown yet": "–", "set": "set to {value}",
    "mean of": "Errors are standard errors of the mean; they shrink with the square root of time. Grey ones are guesses: the run is too short yet. {samples}",
    "independent": "Independent samples so far: {count}.", "not sampled": "Sampling begins after the equilibration.",
    "equation words": "The equation of state is Thol's (2016), for the fluid at the mean density and the set temperature.",
    "T": "temperature", "U": "potential energy", "p": "pressure", "E": "total energy", "γ": "surface tension", "ρ_l": "density of the liquid", "ρ_v": "density of the vapour", "n_c": "neighbours", "D": "diffusion coefficient",

    "charts": "Charts",
    "diagram": "Phase diagram", "diagram caption": "Binodal, and spinodals (dashed), by Thol's equation of state; freezing and melting densities by Mastny and de Pablo (2007). Between binodal and spinodal the fluid is metastable.",
    "binodal": "binodal", "spinodal": "spinodal", "freezing": "freezing", "melting": "melting", "metastable": "metastable", "here": "this run",
    "temperatures": "Temperature in time", "temperatures caption": "The last samples.", "pressures": "Pressure in time", "pressures caption": "The last samples. It fluctuates a lot: the error of its mean is much smaller.",
    "energies": "Energy", "energies caption": "Change of the total energy per atom since sampling began. A thermostat exchanges energy, so it wanders; at constant energy it stays near zero, and its drift tells whether the time step is too long.",
    "rdf": "g(r)", "rdf caption": "Radial distribution function with its error band: 1 where atoms do not feel each other.",
    "sk": "S(k)", "sk caption": "Structure factor: what a beam of neutrons would see.",
    "msd": "Mean square displacement", "msd caption": "How far atoms have wandered after a time. Its slope is six times the diffusion coefficient.",
    "speeds": "Speeds", "speeds caption": "Speeds of the atoms at this moment, and Maxwell's distribution at their temperature.",
    "maxwell": "Maxwell", "observed": "atoms",
    "order": "Order", "order caption": "Verlet's order parameter: 1 in the crystal that the run began with, 0 in a fluid.",
    "profile": "Density across the film", "profile caption": "Mean density in slices: liquid in the middle, vapour outside.",
    "energy error": "Energy error", "energy error caption": "Relative error of the total energy: what the integrator makes of a constant.",

    "deck": "Deck", "deck words": "What runs here, as text. Change it and run it; the same file runs on the command line.",
    "run deck": "Run this deck", "force": "run in spite of unlikely values", "force words": "tick the box below to run it as it is", "deck warnings": "Remarks",
    "home": "Continue at home", "home words": "The same run on your computer, with the same digits. Save the deck{start} and run",
    "home start": " and the start", "home check": "After step {step} the program must show this checksum of all positions:",
    "copy": "Copy", "save deck": "Save the deck", "save start": "Save the start", "link": "Copy a link to this deck", "link copied": "Copied", "link shown": "The link is in the address bar",
    "link kept": "A link cannot hold a run that began from the atoms of another: save deck and start.",

    "exercises": "Exercises", "check answer": "Check",
    "exercise speeds": "Which speed is the most probable one in this run? Read it off the chart of speeds, or compute it from the temperature.",
    "exercise neighbours": "How many neighbours has an atom? Estimate it from g(r): the integral of 4π r² ρ g(r) up to the minimum behind the first peak.",
    "right": "Right: this run has {value}{error}.", "nearly": "Not quite: yours differs by {percent} %. This run's value lies {where}.", "higher": "higher", "lower": "lower",
    "not a number": "Type a number.", "no answer yet": "This run has no value for that yet: let it sample for a while.",

    "blown up": "The run has ended", "blow up words": "A time step that is too long moves atoms into each other, where the force is enormous: the next step throws them out of the box. Go back to a shorter one.",
    "mistakes": "That cannot be run",
    "back": "The atoms are back where they began, to the last bit.", "not back": "The atoms are not back where they began: one bit was flipped on the way.",
    "background": "Goes on in the background.",
    "foot": "This file needs no network; it can be sent and archived as it is. ljmd {version}, GPL-3.0-or-later. Charts by Observable Plot, atoms by three.js.",
    "licences": "Licences of what is inside",
    "digits": "Check the digits", "digits running": "computing …", "digits right": "All digits are those that ljmd {version} has on every machine.", "digits wrong": "These digits are wrong: {problems}. Please report it.",
    "broken": "The engine could not be started: {why}.",
    "skip": "Skip to the content",
    "deck placeholder": "Deck in TOML",
};

/** The words of that name, with their blanks filled in. */
export function word(name, values = {}) {
    const text = WORDS[name];
    if (text === undefined) throw new Error(`no words for '${name}'`);
    return text.replace(/\{(\w+)\}/g, (_, key) => String(values[key] ?? ""));
}
