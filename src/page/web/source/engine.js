// The engine as a function: JSON in, JSON out. Both the Worker and the module for other pages stand on it.

/** What the engine answers instead of a value. `kind`: input, data, physics, memory, other. */
export class EngineError extends Error {
    constructor(message, kind) {
        super(message);
        this.name = "EngineError";
        this.kind = kind;
    }
}

/**
 * @param {Function} factory of the compiled engine (Emscripten's)
 * @param {ArrayBuffer} wasmBinary
 */
export async function makeEngine(factory, wasmBinary) {
    const module = await factory({ wasmBinary });
    /** One call, see src/page/exports.cpp. @throws EngineError */
    const call = (request) => {
        const text = JSON.stringify(request);
        const bytes = module.lengthBytesUTF8(text) + 1;
        const place = module._malloc(bytes);
        if (place === 0) throw new EngineError("there is not enough memory in this browser for that", "memory");
        try {
            module.stringToUTF8(text, place, bytes);
            const answer = JSON.parse(module.UTF8ToString(module._ljmd_call(place)));
            if (answer.error !== undefined) throw new EngineError(answer.error, answer.kind);
            return answer.value;
        } finally {
            module._free(place);
        }
    };
    /** Positions and speeds of the atoms of a fluid, as the viewer takes them. Copies. */
    const picture = (atoms) => {
        module._ljmd_draw();
        const [positions, speeds] = [module._ljmd_positions(), module._ljmd_speeds()];
        return {
            positions: module.HEAPU16.slice(positions / 2, positions / 2 + 3 * atoms),
            speeds: module.HEAPU8.slice(speeds, speeds + atoms),
        };
    };
    return { call, picture };
}
