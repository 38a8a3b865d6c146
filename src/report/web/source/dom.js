// Makes elements. Text goes in as text nodes, so nothing that a payload holds can become markup.

/**
 * @param {string} tag
 * @param {Object<string, unknown>} [attributes] `on...` with a function: a listener; null, undefined and false: left out
 * @param {...(Node|string|number|null|undefined|Array)} children
 * @returns {HTMLElement}
 */
export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) continue;
        if (typeof value === "function") made.addEventListener(name.replace(/^on/, ""), value);
        else made.setAttribute(name, value === true ? "" : String(value));
    }
    made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false)
        .map((child) => (child instanceof Node ? child : String(child))));
    return made;
}

const taken = new Map();

/** An id for an element, from a text of the payload; unique on the page. */
export function uniqueId(text) {
    const base = `s-${String(text).toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 40) || "x"}`;
    const count = (taken.get(base) ?? 0) + 1;
    taken.set(base, count);
    return count === 1 ? base : `${base}-${count}`;
}

/** A section with a heading that the navigation can lead to. */
export function section(title, level, ...children) {
    const heading = element(`h${level}`, { id: uniqueId(title) }, title);
    return element("section", { "aria-labelledby": heading.id }, heading, ...children);
}

/** A region that scrolls sideways, reached by the keyboard, too. */
export function scroller(label, child) {
    return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, child);
}
