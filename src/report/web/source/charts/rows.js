// Rows for Observable Plot, from the columns that a mark names.
import { column, hasColumn } from "../tabular.js";

const usable = (value, scale) => value !== null && value !== undefined && (scale !== "log" || value > 0);

/**
 * One object a row: x, y, low, high, fill, flag, group, tip, those that the mark names. Values that cannot be drawn
 * (null, not positive on a log axis) are NaN: lines have a gap there.
 */
export function rowsOf(mark, chart, tables) {
    const table = tables.get(mark.table);
    if (!table) return [];
    const get = (name) => (hasColumn(table, name) ? column(table, name) : null);
    const [x, y, error, low, high] = [mark.x, mark.y, mark.error, mark.low, mark.high].map(get);
    const [fill, flag, group, tip] = [mark.fill, mark.flag, mark.group, mark.tip].map(get);
    const at = (values, row, scale) => (values && usable(values[row], scale) ? values[row] : NaN);
    const { scale: xScale } = chart.x ?? {};
    const { scale: yScale } = chart.y ?? {};
    return Array.from({ length: table.values[0]?.length ?? 0 }, (_, row) => {
        const value = at(y, row, yScale);
        const width = error && error[row] !== null ? error[row] : NaN;
        return {
            x: at(x, row, xScale), y: value,
            low: low ? at(low, row, yScale) : lowEnd(value, width, yScale),
            high: high ? at(high, row, yScale) : value + width,
            error: width, fill: at(fill, row), flag: Boolean(flag?.[row]), group: group ? String(group[row]) : null,
            tip: tip ? String(tip[row] ?? "") : null,
        };
    });
}

/** Below zero a log axis has no place: the band then ends a decade below its value. */
function lowEnd(value, width, scale) {
    return scale === "log" && value - width <= 0 ? value / 10 : value - width;
}

/** Texts in their order of appearance, numbers by size. */
export function categories(values) {
    const distinct = [...new Set(values.filter((value) => typeof value === "string" || Number.isFinite(value)))];
    return distinct.every((value) => typeof value === "number") ? distinct.sort((a, b) => a - b) : distinct;
}
