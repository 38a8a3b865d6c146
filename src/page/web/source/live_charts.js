// The charts of the page: what each shows, and when it is drawn again. All values come from the engine.
import { chartFigure } from "../../../report/web/source/charts/figure.js";
import { element } from "../../../report/web/source/dom.js";
import { word } from "./words.js";

const MOST_POINTS = 400;

/** A table for a chart, from columns by name. */
const table = (name, columns) => ({ name, columns: Object.keys(columns).map((key) => ({ name: key })), values: Object.values(columns) });

function thinned(rows) {
    const every = Math.ceil(rows.length / MOST_POINTS);
    return every <= 1 ? rows : rows.filter((_, place) => place % every === every - 1);
}

const column = (rows, place) => rows.map((row) => row[place]);

/** The table of an analysis under other names of its columns. */
function columnsOf(tables, name, wanted) {
    const found = tables.find((entry) => entry.name === name);
    if (!found) return null;
    const columns = {};
    for (const [key, from] of Object.entries(wanted)) {
        const place = found.columns.indexOf(from);
        if (place >= 0) columns[key] = found.values[place];
    }
    return columns;
}

/** One chart: its place on the page, its tables, and `columns`, which makes a table of what is known. */
class LiveChart {
    constructor(chart, names, columns) {
        this.tables = new Map(names.map((name) => [name, table(name, {})]));
        this.columns = columns;
        this.chart = chart;
        this.figure = chartFigure(chart, this.tables, null, 3);
        this.node = this.figure.node;
        // A chart out of sight is old; whoever comes to it, or saves it, sees the newest.
        for (const arrival of ["pointerenter", "focusin"]) this.node.addEventListener(arrival, () => this.known && this.update(this.known));
    }

    update(known) {
        this.known = known;
        const all = this.columns(known);
        this.node.hidden = all === null;
        if (all === null) return;
        for (const [name, columns] of Object.entries(all)) this.tables.set(name, table(name, columns));
        this.figure.redraw();
    }
}

const curve = (name, label, colour, more = {}) => ({ type: "line", table: name, x: "x", y: "y", label, colour, ...more });

function diagramChart() {
    const marks = [
        curve("binodal", word("binodal"), 0), curve("spinodal", word("spinodal"), 0, { dash: true }),
        curve("freezing", word("freezing"), 2), curve("melting", word("melting"), 3),
        { type: "dots", table: "here", x: "x", y: "y", label: word("here"), colour: 1 },
    ];
    const chart = { id: "diagram", title: word("diagram"), caption: word("diagram caption"), x: { label: "rho / sigma^-3" }, y: { label: "T / (epsilon/k_B)" }, marks };
    return new LiveChart(chart, ["binodal", "spinodal", "freezing", "melting", "here"], ({ diagram, controls, fluid }) => {
        if (!diagram || !fluid) return null;
        const { saturation, freezing } = diagram;
        const there = saturation.filter((row) => row[0] >= diagram.triple_temperature);
        const back = [...there].reverse();
        const low = freezing.filter((row) => row[0] <= 2.6);
        return {
            binodal: { x: [...column(there, 1), ...column(back, 4)], y: [...column(there, 0), ...column(back, 0)] },
            spinodal: { x: [...column(there, 2), ...column(back, 3)], y: [...column(there, 0), ...column(back, 0)] },
            freezing: { x: column(low, 1), y: column(low, 0) },
            melting: { x: column(low, 2), y: column(low, 0) },
            here: { x: [controls.density], y: [controls.temperature] },
        };
    });
}

function historyChart(id, symbol, unit, name, colour) {
    const chart = { id, title: word(id), caption: word(`${id} caption`), x: { label: "t / tau" }, y: { label: `${symbol} / (${unit})` }, marks: [curve(id, word(symbol), colour)] };
    return new LiveChart(chart, [id], ({ rows, place, fluid }) => {
        if (!fluid) return null;
        const last = thinned(rows.slice(-4 * MOST_POINTS));
        return { [id]: { x: column(last, place.time), y: column(last, place[name]) } };
    });
}

function energyChart() {
    const chart = { id: "energies", title: word("energies"), caption: word("energies caption"), x: { label: "t / tau" }, y: { label: "E(t) - E(0)" }, marks: [curve("E", word("E"), 4)] };
    return new LiveChart(chart, ["E"], ({ rows, place, fluid, firstSampled }) => {
        if (!fluid) return null;
        const stage = rows.filter((row) => row[place.step] >= firstSampled);
        const first = stage.find((row) => row[place.total_energy] !== null)?.[place.total_energy] ?? 0;
        const last = thinned(stage);
        return { E: { x: column(last, place.time), y: column(last, place.total_energy).map((value) => value - first) } };
    });
}

function orderChart() {
    const chart = { id: "order", title: word("order"), caption: word("order caption"), x: { label: "t / tau" }, y: { label: "lambda" }, marks: [curve("order", word("order"), 3)] };
    return new LiveChart(chart, ["order"], ({ rows, place, fluid }) => {
        if (!fluid || !rows.some((row) => row[place.order] !== null)) return null;
        const last = thinned(rows);
        return { order: { x: column(last, place.time), y: column(last, place.order) } };
    });
}

function analysisChart(name, { id, x, y, from, error }) {
    const chart = { id, title: word(id), caption: word(`${id} caption`), x: { label: x }, y: { label: y }, marks: [curve(name, word(id), 0, error ? { error: "error" } : {})] };
    return new LiveChart(chart, [name], ({ tables }) => {
        const columns = columnsOf(tables ?? [], name, { ...from, error });
        return columns && columns.x?.length > 1 ? { [name]: columns } : null;
    });
}

function speedsChart() {
    const chart = { id: "speeds", title: word("speeds"), caption: word("speeds caption"), x: { label: "v / (sigma/tau)" }, y: { label: "f(v)" }, marks: [
        { type: "dots", table: "speeds", x: "x", y: "y", error: "error", label: word("observed"), colour: 0 }, curve("maxwell", word("maxwell"), 1)] };
    return new LiveChart(chart, ["speeds", "maxwell"], ({ speeds }) => {
        if (!speeds) return null;
        const [x, y, error, maxwell] = speeds.values;
        return { speeds: { x, y, error }, maxwell: { x, y: maxwell } };
    });
}

function errorChart() {
    const chart = { id: "energy-error", title: word("energy error"), caption: word("energy error caption"), x: { label: "t" }, y: { label: "energy error" }, marks: [curve("error", word("energy error"), 0)] };
    return new LiveChart(chart, ["error"], ({ rows, place, fluid }) => {
        if (fluid !== false || rows.length === 0) return null;
        const first = rows[0][place.total_energy];
        const last = thinned(rows);
        return { error: { x: column(last, place.time), y: column(last, place.total_energy).map((value) => (value - first) / (Math.abs(first) || 1)) } };
    });
}

export class LiveCharts {
    constructor() {
        this.all = [
            diagramChart(), orderChart(), historyChart("temperatures", "T", "epsilon/k_B", "temperature", 0),
            historyChart("pressures", "p", "epsilon/sigma^3", "pressure", 1), energyChart(),
            analysisChart("rdf", { id: "rdf", x: "r / sigma", y: "g", from: { x: "r", y: "g" }, error: "g_standard_error" }),
            analysisChart("sk", { id: "sk", x: "k sigma", y: "S", from: { x: "k", y: "S" }, error: "S_standard_error" }),
            analysisChart("msd", { id: "msd", x: "t / tau", y: "<|r(t) - r(0)|^2> / sigma^2", from: { x: "time", y: "msd" }, error: "standard_error" }),
            speedsChart(),
            analysisChart("film", { id: "profile", x: "z / sigma", y: "rho / sigma^-3", from: { x: "z", y: "density" }, error: "density_standard_error" }),
            errorChart(),
        ];
        this.node = element("div", { class: "charts" }, this.all.map((chart) => chart.node));
        this.next = 0;
    }

    /** All charts; what has just changed is not only more of the same. */
    update(known) {
        for (const chart of this.all) chart.update(known);
    }

    /** One chart that is on the screen, in turn: drawing all at once would halt the picture. */
    updateNext(known) {
        for (const chart of this.all) chart.known = known;
        for (let tried = 0; tried < this.all.length; ++tried) {
            const chart = this.all[this.next];
            this.next = (this.next + 1) % this.all.length;
            const { top, bottom } = chart.node.getBoundingClientRect();
            if (!chart.node.hidden && (bottom < 0 || top > window.innerHeight)) continue;
            chart.update(known);
            return;
        }
    }
}

