// Dark and light: as the system says, until the reader chooses.
import { element } from "./dom.js";

const SYSTEM = window.matchMedia("(prefers-color-scheme: dark)");
let chosen = null;

export function isDark() {
    return (chosen ?? (SYSTEM.matches ? "dark" : "light")) === "dark";
}

function apply(button) {
    const dark = isDark();
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    button.setAttribute("aria-pressed", String(dark));
    document.dispatchEvent(new CustomEvent("themechange"));
}

/** The switch. Charts and text follow by CSS variables; the viewer listens for "themechange". */
export function themeSwitch() {
    const button = element("button", { type: "button", class: "theme", "aria-label": "Dark colours" },
        element("span", { class: "theme-icon", "aria-hidden": "true" }));
    button.addEventListener("click", () => {
        chosen = isDark() ? "light" : "dark";
        apply(button);
    });
    SYSTEM.addEventListener("change", () => apply(button));
    apply(button);
    return button;
}
