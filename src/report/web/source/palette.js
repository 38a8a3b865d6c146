// Colours that the colour-blind can tell apart: roles for series (after Okabe and Ito, as CSS variables in the style
// sheet, so that dark, light and print differ), and viridis for magnitudes.

export const ROLES = 8;

/** The colour of a role, for SVG. */
export function role(place) {
    return `var(--role-${((place % ROLES) + ROLES) % ROLES})`;
}

/** The colour of a role as an element shows it now, for canvases. */
export function roleNow(place, node = document.documentElement) {
    return getComputedStyle(node).getPropertyValue(`--role-${place % ROLES}`).trim();
}

const VIRIDIS = ["440154", "482475", "414487", "355f8d", "2a788e", "21918c", "22a884", "44bf70", "7ad151", "bddf26", "fde725"]
    .map((hex) => [0, 2, 4].map((place) => parseInt(hex.slice(place, place + 2), 16)));

/** Viridis at 0..1 as [red, green, blue] of 0..255. */
export function viridis(at) {
    const scaled = Math.min(Math.max(at, 0), 1) * (VIRIDIS.length - 1);
    const low = Math.min(Math.floor(scaled), VIRIDIS.length - 2);
    return VIRIDIS[low].map((value, channel) => Math.round(value + (scaled - low) * (VIRIDIS[low + 1][channel] - value)));
}

export function css([red, green, blue]) {
    return `rgb(${red}, ${green}, ${blue})`;
}

/** Black or white, whichever is read on a colour. */
export function inkOn([red, green, blue]) {
    return 0.299 * red + 0.587 * green + 0.114 * blue > 140 ? "#000" : "#fff";
}
