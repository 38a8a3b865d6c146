// Downloads, made in the page: no server is asked.
import { element } from "./dom.js";

/** A name for a file from a text of the payload. */
export function fileName(text, ending) {
    const base = String(text).replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[-.]+|-+$/g, "").slice(0, 80) || "ljmd";
    return base.endsWith(ending) ? base : base + ending;
}

/** Offers a text or an image as a file. @param {string|Blob} content */
export function save(name, content, type = "text/plain") {
    const blob = content instanceof Blob ? content : new Blob([content], { type: `${type};charset=utf-8` });
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A button that saves what `make` returns. */
export function saveButton(label, name, make, type) {
    return element("button", { type: "button", class: "small", onclick: () => save(name, make(), type) }, label);
}

/** A button that copies a text; where the clipboard is refused, it selects the text instead. */
export function copyButton(label, source) {
    const button = element("button", { type: "button", class: "small" }, label);
    button.addEventListener("click", async () => {
        try {
            await navigator.clipboard.writeText(source.textContent);
            button.textContent = "Copied";
        } catch {
            window.getSelection().selectAllChildren(source);
            button.textContent = "Selected: press Ctrl+C";
        }
        setTimeout(() => (button.textContent = label), 2000);
    });
    return button;
}
