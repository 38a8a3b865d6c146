// The engine in its Worker: answers requests, and plays: steps, then a picture, then it waits until that is drawn.
import { makeEngine } from "./engine.js";

const PICTURE = 38;     // milliseconds between pictures at full speed, at least
const PIECE = 10;       // milliseconds of computing at full speed between looks at the messages

let engine = null;
let run = null;         // what was opened
let serial = 0;         // of what was opened: pictures of another run may still be under way
let playing = false;
let drawing = false;    // the page has a picture that it has not drawn yet
let pace = 10;          // steps a picture; 0: as many as there is time for
let fast = 10;          // that many in a piece at full speed
let untold = null;      // what was computed since the last picture
let shownAt = 0;

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

/** Puts together what several pieces have computed. */
function joined(before, state) {
    if (before === null) return state;
    return { ...state, rows: [...before.rows, ...state.rows], steps: before.steps + state.steps, milliseconds: before.milliseconds + state.milliseconds };
}

function play() {
    const full = pace === 0;
    // At full speed the run goes on while a picture is drawn; else it waits for that.
    if (!playing || (drawing && !full)) return;
    try {
        const state = advance(full ? fast : pace);
        if (full) fast = Math.max(1, Math.min(Math.round((fast * PIECE) / Math.max(state.milliseconds, 0.5)), 4 * fast));
        untold = joined(untold, state);
        if (state.finished) playing = false;
        if (state.finished || (!drawing && (!full || performance.now() - shownAt >= PICTURE))) {
            drawing = true;
            shownAt = performance.now();
            const whole = untold;
            untold = null;
            postMessage(...pictureNow({ ...whole, playing }));
        }
        if (full) soon();
    } catch (error) {
        playing = false;
        postMessage({ stopped: failureOf(error) });
    }
}
let isWaiting = false;  // for its turn
turn.port2.onmessage = () => {
    isWaiting = false;
    play();
};
function soon() {
    if (!isWaiting) turn.port1.postMessage(null);
    isWaiting = true;
}

const commands = {
    play: () => { playing = true; soon(); },
    pause: () => {
        playing = false;
        if (untold !== null) postMessage(...pictureNow({ ...untold, playing }));
        untold = null;
    },
    drawn: () => {
        drawing = false;
        if (pace > 0) soon();
    },
    pace: ({ steps }) => {
        pace = steps;
        soon();
    },
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
        let value = request.call === "advance" ? advance(request.steps) : engine.call(request);
        if (request.call === "open") {
            playing = false;
            serial += 1;
            run = value = { ...value, serial };
            fast = 10;
            drawing = false;
            untold = null;
        }
        postMessage({ id, value });
        if (request.call === "advance" && request.shown) postMessage(...pictureNow({ ...value, rows: [], playing: false }));
    } catch (error) {
        postMessage({ id, failure: failureOf(error) });
    }
};
