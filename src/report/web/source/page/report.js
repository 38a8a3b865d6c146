// The sections of a payload, in the order in which they are read.
import { chartFigure } from "../charts/figure.js";
import { element, section } from "../dom.js";
import { atomViewer } from "../viewer/atoms.js";
import { energyErrorChart, trackViewer } from "../viewer/tracks.js";
import { downloadsSection } from "./downloads.js";
import { comparedSection, memberList, overlaidCharts } from "./members.js";
import { pointsSection } from "./points.js";
import { resultsSection } from "./results.js";
import { pairs, tablesSection } from "./tables.js";
import { verdictSection } from "./verdict.js";

/** What plays, and the chart of its energy error where the payload brings none. */
function viewers(payload, charts, tables) {
    const title = payload.title || payload.source || "the run";
    const tracks = payload.tracks ? trackViewer(payload.tracks, title) : null;
    if (tracks && payload.tracks.energy_error?.length > 0 && !charts.some((chart) => chart.lead && withCursor(chart).cursor)) {
        const { chart, table } = energyErrorChart(payload.tracks);
        charts.unshift(chart);
        tables.push(table);
    }
    const atoms = payload.atoms ? atomViewer(payload.atoms, title) : null;
    return { tracks, atoms, playback: (tracks ?? atoms)?.playback ?? null };
}

/** A chart over the time follows the playback. */
function withCursor(chart) {
    return { ...chart, cursor: chart.cursor ?? /^t( \/|$)/.test(chart.x?.label ?? "") };
}

/** What a chart needs of a playback. */
function clock(playback) {
    return playback && {
        get time() {
            return playback.time;
        },
        onTime: (listener) => playback.onTime(listener),
        seek: (time) => playback.seek(time),
    };
}

function chartGrid(figures) {
    return figures.length > 0 ? element("div", { class: "charts" }, figures.map((figure) => figure.node)) : null;
}

/**
 * @param {object} payload
 * @param {number} level of the headings: 2 for the page, 3 for a run within a page of several
 * @returns {HTMLElement[]}
 */
export function reportSections(payload, level = 2) {
    const members = payload.members ?? [];
    const overlaid = overlaidCharts(members, payload.charts ?? []);
    const charts = [...(payload.charts ?? []), ...overlaid.charts];
    const tables = [...(payload.tables ?? [])];
    const { tracks, atoms, playback } = viewers(payload, charts, tables);
    const byName = new Map([...tables, ...overlaid.tables].map((table) => [table.name, table]));
    const figures = charts.map((chart) => ({ chart, ...chartFigure(withCursor(chart), byName, clock(playback), level + 1) }));
    const lead = figures.filter(({ chart }) => chart.lead);
    const rest = figures.filter(({ chart }) => !chart.lead);
    const provenance = [...Object.entries(payload.program ?? {}), ...(payload.provenance ?? [])];
    // Few bodies lead with the playback, beside the error that it is linked to.
    const linked = tracks ? lead.filter(({ chart }) => withCursor(chart).cursor) : [];
    const leading = lead.filter((figure) => !linked.includes(figure));
    // A run leads with its results; a study with the picture of all its points.
    const chartsFirst = payload.kind !== "run" && leading.length > 0;
    const sections = [
        verdictSection(payload, level),
        tracks && section("Playback", level, element("div", { class: "linked" }, tracks.node, chartGrid(linked))),
        members.length > 0 && comparedSection(members, level),
        chartsFirst && section("Overview", level, chartGrid(leading)),
        resultsSection(payload, level),
        (rest.length > 0 || (leading.length > 0 && !chartsFirst)) && section("Charts", level, chartGrid(chartsFirst ? rest : [...leading, ...rest])),
        atoms && section("Atoms", level, atoms.node),
        pointsSection(payload.points ?? [], level, payload.kind === "reference" ? "Runs" : "Points"),
        members.length > 0 && memberList(members, level, (member) => reportSections(member, level + 1)),
        tablesSection(tables, level),
        provenance.length > 0 && section("Provenance", level, pairs(provenance, "Provenance")),
        downloadsSection({ ...payload, tables }, figures, level),
    ];
    return sections.filter(Boolean);
}
