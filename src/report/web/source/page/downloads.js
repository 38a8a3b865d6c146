// What a reader takes along: tables, charts, a paragraph on the methods, the deck.
import { element, section } from "../dom.js";
import { copyButton, fileName, save, saveButton } from "../save.js";
import { csv } from "../tabular.js";

function text(title, name, content, open) {
    if (!content) return null;
    const block = element("pre", { tabindex: 0, role: "region", "aria-label": title }, content);
    return element("details", { open: Boolean(open) }, element("summary", {}, title), block,
        element("p", { class: "buttons" }, copyButton("Copy", block), saveButton("Save", name, () => content)));
}

/**
 * @param {{title: string, save: () => string, name: string}[]} charts those that are on the page
 */
export function downloadsSection(payload, charts, level) {
    const downloads = payload.downloads ?? {};
    const tables = payload.tables ?? [];
    const files = [
        ...tables.map((table) => ({ label: table.title || table.name, name: fileName(table.file || table.name, ".csv"), make: () => csv(table), type: "text/csv" })),
        ...charts.map((chart) => ({ label: chart.title, name: fileName(chart.id, ".svg"), make: chart.svg, type: "image/svg+xml" })),
    ];
    if (files.length === 0 && !downloads.methods && !downloads.deck && !downloads.bibtex) return null;
    return section("Downloads", level,
        text("Methods, as a paragraph to paste", "methods.txt", downloads.methods, true),
        text("References (BibTeX)", "references.bib", downloads.bibtex),
        text("The deck as used", "deck.toml", downloads.deck),
        files.length > 0 && element("ul", { class: "files" }, files.map((file) => element("li", {},
            element("button", { type: "button", class: "file", onclick: () => save(file.name, file.make(), file.type) },
                element("span", { class: "ending" }, file.name.slice(file.name.lastIndexOf(".") + 1).toUpperCase()), " ",
                element("bdi", {}, file.label))))));
}
