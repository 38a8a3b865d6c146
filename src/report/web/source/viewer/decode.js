// Numbers that a payload carries as base64, little-endian.

/** @param {string} text @returns {Uint8Array} */
export function bytes(text) {
    const packed = atob(text);
    const made = new Uint8Array(packed.length);
    for (let place = 0; place < packed.length; ++place) made[place] = packed.charCodeAt(place);
    return made;
}

/** Whole elements only: a file that was cut off gives what is there. */
function view(Type, text) {
    const raw = bytes(text);
    return new Type(raw.buffer, 0, Math.floor(raw.length / Type.BYTES_PER_ELEMENT));
}

export const uint16 = (text) => view(Uint16Array, text);
export const uint32 = (text) => view(Uint32Array, text);
export const float32 = (text) => view(Float32Array, text);

/**
 * The atoms of a payload, ready to be drawn; null where no frame is whole.
 * @typedef {{count: number, frames: number, times: number[], steps: number[], positions: Uint16Array,
 *     ids: Uint32Array|null, colours: {name: string, label: string, low: number, high: number, values: Uint8Array}[],
 *     box: (frame: number) => number[]}} Atoms
 * @returns {Atoms|null}
 */
export function decodeAtoms(data) {
    const count = data.shown_atoms ?? data.atoms;
    const positions = uint16(data.positions ?? "");
    const frames = count > 0 ? Math.floor(positions.length / (3 * count)) : 0;
    if (frames === 0) return null;
    const ids = data.ids ? uint32(data.ids) : null;
    const colours = (data.colours ?? []).map((colour) => ({ ...colour, values: bytes(colour.values) }))
        .filter((colour) => colour.values.length >= frames * count);
    colours.push(colourById(frames, count, ids));
    return {
        count, frames, positions, ids, colours,
        times: data.times ?? [], steps: data.steps ?? [],
        box: (frame) => data.box[Math.min(frame, data.box.length - 1)],
    };
}

/** Colours along the ids, the same in every frame: shows how far a crystal or two halves have mixed. */
function colourById(frames, count, ids) {
    const one = new Uint8Array(count);
    const highest = ids ? ids.reduce((a, b) => Math.max(a, b), 1) : Math.max(count - 1, 1);
    for (let atom = 0; atom < count; ++atom) one[atom] = Math.round((255 * (ids ? ids[atom] : atom)) / highest);
    return { name: "id", label: "number of the atom", low: 0, high: highest, values: one, still: true };
}

/** The colour values of a frame. */
export function coloursAt(colour, frame, count) {
    return colour.still ? colour.values : colour.values.subarray(frame * count, (frame + 1) * count);
}
