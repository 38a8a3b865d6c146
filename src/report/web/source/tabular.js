// Tables of a payload: columns by name, rows, CSV.

/** @typedef {{name: string, title?: string, columns: {name: string, label?: string, unit?: string, error_of?: string}[], values: unknown[][], file?: string, rows?: number, shown?: number, lead?: boolean, flag?: string}} Table */

/** @param {Table} table @returns {unknown[]} empty where the table has no such column */
export function column(table, name) {
    const place = table.columns.findIndex((entry) => entry.name === name);
    return place < 0 ? [] : table.values[place] ?? [];
}

/** @param {Table} table */
export function hasColumn(table, name) {
    return name !== undefined && table.columns.some((entry) => entry.name === name);
}

/** @param {Table} table */
export function rowCount(table) {
    return table.values[0]?.length ?? 0;
}

/** The table as CSV (RFC 4180). Texts that a spreadsheet would take for a formula get an apostrophe. */
export function csv(table) {
    const cell = (value) => {
        if (value === null || value === undefined) return "";
        if (typeof value !== "string") return String(value);
        const safe = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
        return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
    };
    const lines = [table.columns.map((entry) => cell(entry.name)).join(",")];
    for (let row = 0; row < rowCount(table); ++row) lines.push(table.values.map((values) => cell(values[row])).join(","));
    return `${lines.join("\r\n")}\r\n`;
}
