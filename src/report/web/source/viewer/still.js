// Atoms on a 2D canvas: for browsers without WebGL, and for print.
import { css, viridis } from "../palette.js";

const TONES = 32;

/** Shaded discs, one a tone, that are copied for each atom. */
function discs(size) {
    return Array.from({ length: TONES }, (_, tone) => {
        const disc = document.createElement("canvas");
        disc.width = disc.height = size;
        const pen = disc.getContext("2d");
        const colour = viridis(tone / (TONES - 1));
        const half = size / 2;
        const shade = pen.createRadialGradient(0.68 * half, 0.6 * half, 0.05 * half, half, half, half);
        shade.addColorStop(0, css(colour.map((value) => Math.min(255, value + 70))));
        shade.addColorStop(0.5, css(colour));
        shade.addColorStop(1, css(colour.map((value) => Math.round(value * 0.45))));
        pen.fillStyle = shade;
        pen.beginPath();
        pen.arc(half, half, half - 0.5, 0, 2 * Math.PI);
        pen.fill();
        return disc;
    });
}

function drawBox(pen, box, project, ink) {
    const corner = (place) => project(...box.map((edge, axis) => ((place >> axis) & 1 ? 0.5 : -0.5) * edge));
    pen.strokeStyle = ink;
    pen.lineWidth = 1;
    pen.beginPath();
    for (let a = 0; a < 8; ++a) {
        for (const axis of [1, 2, 4]) {
            if (a & axis) continue;
            const [from, to] = [corner(a), corner(a | axis)];
            pen.moveTo(from[0], from[1]);
            pen.lineTo(to[0], to[1]);
        }
    }
    pen.stroke();
}

/**
 * @param {HTMLCanvasElement} canvas of the size of the picture
 * @param {{positions: Uint16Array, box: number[], shades: Uint8Array, radius: number}} frame
 * @param {import("./camera.js").Camera} camera
 * @param {{ground: string, edge: string}} colours
 */
export function drawStill(canvas, { positions, box, shades, radius }, camera, colours) {
    const pen = canvas.getContext("2d");
    const { width, height } = canvas;
    const project = camera.projection(width, height);
    pen.fillStyle = colours.ground;
    pen.fillRect(0, 0, width, height);
    drawBox(pen, box, project, colours.edge);
    const seen = [];
    for (let atom = 0; atom < shades.length; ++atom) {
        const at = [0, 1, 2].map((axis) => (positions[3 * atom + axis] / 65536 - 0.5) * box[axis]);
        const [x, y, depth, pixels] = project(...at);
        if (pixels > 0) seen.push([depth, x, y, radius * pixels, shades[atom]]);
    }
    seen.sort((a, b) => b[0] - a[0]);
    const sprites = discs(64);
    for (const [, x, y, size, shade] of seen) {
        pen.drawImage(sprites[Math.round((shade / 255) * (TONES - 1))], x - size, y - size, 2 * size, 2 * size);
    }
}
