// Which atom is under the pointer, and where it goes.

/** @returns {number} the place of the nearest atom at a point of the picture; -1: none */
export function pick(positions, box, radius, project, x, y) {
    let best = -1;
    let nearest = Infinity;
    for (let atom = 0; 3 * atom < positions.length; ++atom) {
        const [atX, atY, depth, pixels] = project(...[0, 1, 2].map((axis) => (positions[3 * atom + axis] / 65536 - 0.5) * box[axis]));
        if (pixels > 0 && depth < nearest && Math.hypot(atX - x, atY - y) <= radius * pixels) {
            best = atom;
            nearest = depth;
        }
    }
    return best;
}

/**
 * The way of an atom from frame to frame, each step to the nearest image.
 * @param {import("./decode.js").Atoms} atoms
 * @returns {Float32Array} pairs of points
 */
export function way(atoms, atom) {
    const ends = new Float32Array(Math.max(0, atoms.frames - 1) * 6);
    for (let frame = 0; frame + 1 < atoms.frames; ++frame) {
        const box = atoms.box(frame);
        for (let axis = 0; axis < 3; ++axis) {
            const from = atoms.positions[3 * (frame * atoms.count + atom) + axis];
            const to = atoms.positions[3 * ((frame + 1) * atoms.count + atom) + axis];
            // The difference of two 16-bit fractions, read as signed, is that to the nearest image.
            const step = ((to - from) << 16) >> 16;
            ends[6 * frame + axis] = (from / 65536 - 0.5) * box[axis];
            ends[6 * frame + 3 + axis] = ((from + step) / 65536 - 0.5) * box[axis];
        }
    }
    return ends;
}
