// Turns a camera by mouse, fingers and keyboard.

const TURN = 0.008;

/**
 * @param {HTMLElement} target takes the focus
 * @param {import("./camera.js").Camera} camera
 * @param {{changed: () => void, click: (x: number, y: number) => void}} calls `click` in pixels of the target
 */
export function steer(target, camera, { changed, click }) {
    const pointers = new Map();
    let travelled = 0;
    let spread = 0;

    const spreadNow = () => {
        const [a, b] = [...pointers.values()];
        return Math.hypot(a.x - b.x, a.y - b.y);
    };
    target.addEventListener("pointerdown", (event) => {
        target.setPointerCapture(event.pointerId);
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        if (pointers.size === 1) travelled = 0;
        if (pointers.size === 2) spread = spreadNow();
    });
    target.addEventListener("pointermove", (event) => {
        const before = pointers.get(event.pointerId);
        if (!before) return;
        const [right, down] = [event.clientX - before.x, event.clientY - before.y];
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        travelled += Math.abs(right) + Math.abs(down);
        if (pointers.size === 1) camera.turn(-right * TURN, down * TURN);
        if (pointers.size === 2 && spread > 0) {
            camera.scale(spreadNow() / spread);
            spread = spreadNow();
        }
        changed();
    });
    const release = (event) => {
        if (!pointers.delete(event.pointerId)) return;
        const box = target.getBoundingClientRect();
        if (event.type === "pointerup" && travelled < 5) click(event.clientX - box.left, event.clientY - box.top);
    };
    target.addEventListener("pointerup", release);
    target.addEventListener("pointercancel", release);

    // The wheel scrolls the page until the viewer has been clicked.
    target.addEventListener("wheel", (event) => {
        if (document.activeElement !== target) return;
        event.preventDefault();
        camera.scale(Math.exp(-event.deltaY * 0.0015));
        changed();
    }, { passive: false });

    const keys = {
        ArrowLeft: () => camera.turn(-0.1, 0), ArrowRight: () => camera.turn(0.1, 0),
        ArrowUp: () => camera.turn(0, 0.1), ArrowDown: () => camera.turn(0, -0.1),
        "+": () => camera.scale(1.15), "=": () => camera.scale(1.15), "-": () => camera.scale(1 / 1.15), 0: () => camera.reset(),
    };
    target.addEventListener("keydown", (event) => {
        const act = keys[event.key];
        if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        act();
        changed();
    });
}
