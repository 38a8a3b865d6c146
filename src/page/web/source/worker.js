// The engine in its Worker: answers requests, and plays: steps, then a picture, then it waits until that is drawn.
import { makeEngine } from "./engine.js";

const FULL_SPEED = 35;  // milliseconds of computing for a picture

let engine = null;
let run = null;         // what was opened
let serial = 0;         // of what was opened: pictures of another run may still be under way
let playing = false;
let drawing = false;    // the page has a picture that it has not drawn yet
let pace = 10;          // steps a picture; 0: as many as there is time for
let fast = 10;          // that many at full speed

const turn = new MessageChannel();  // unlike a timer it is not slowed down in the background

function failureOf(error) {
    return { error: error.message, kind: error.kind ?? "other" };
}

function pictureNow(state) {
    const picture = run.kind === "fluid" ? engine.picture(run.atoms) : {};
    return [{ frame: { ...state, ...picture, serial } }, run.kind === "fluid" ? [picture.positions.buffer, picture.speeds.buffer] : []];
}

function advance(steps) {
    const begin = performance.now();
    const state = engine.call({ call: "advance", steps });
    return { ...state, milliseconds: performance.now() - begin, steps };
}

function play() {
    if (!playing || drawing) return;
    try {
        const state = advance(pace > 0 ? pace : fast);
        if (pace === 0) fast = Math.max(1, Math.min(Math.round((fast * FULL_SPEED) / Math.max(state.milliseconds, 1)), 4 * fast));
        if (state.finished) playing = false;
        drawing = true;
        postMessage(...pictureNow({ ...state, playing }));
    } catch (error) {
        playing = false;
        postMessage({ stopped: failureOf(error) });
    }
}
turn.port2.onmessage = play;
const soon = () => turn.port1.postMessage(null);

const commands = {
    play: () => { playing = true; soon(); },
    pause: () => { playing = false; },
    drawn: () => { drawing = false; soon(); },
    pace: ({ steps }) => { pace = steps; },
};

onmessage = async ({ data }) => {
    if (data.engine) {
        try {
            engine = await makeEngine(globalThis.ljmdEngine, data.engine);
            postMessage({ ready: engine.call({ call: "version" }) });
        } catch (error) {
            postMessage({ broken: error.message });
        }
        return;
    }
    if (data.command) {
        commands[data.command](data);
        return;
    }
    const { id, request } = data;
    try {
        if (request.call === "open") playing = false;
        let value = request.call === "advance" ? advance(request.steps) : engine.call(request);
        if (request.call === "open") {
            serial += 1;
            run = value = { ...value, serial };
            fast = 10;
            drawing = false;
        }
        postMessage({ id, value });
        if (request.call === "advance" && request.shown) postMessage(...pictureNow({ ...value, playing: false }));
    } catch (error) {
        postMessage({ id, failure: failureOf(error) });
    }
};
