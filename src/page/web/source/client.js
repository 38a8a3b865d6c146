// The Worker as the page sees it: calls that return promises, and pictures while it plays.
import { EngineError } from "./engine.js";

export class Client {
    /** @param {string} code of the Worker @param {ArrayBuffer} engine WebAssembly */
    constructor(code, engine) {
        this.calls = new Map();
        this.last = 0;
        this.listeners = { frame: [], stopped: [] };
        this.worker = new Worker(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
        this.ready = new Promise((resolve, reject) => {
            this.worker.onmessage = ({ data }) => {
                if (data.ready) resolve(data.ready);
                else if (data.broken) reject(new Error(data.broken));
                else this.take(data);
            };
            this.worker.onerror = (event) => reject(new Error(event.message));
        });
        this.worker.postMessage({ engine }, [engine]);
    }

    take(data) {
        if (data.frame) {
            for (const listener of this.listeners.frame) listener(data.frame);
        } else if (data.stopped) {
            for (const listener of this.listeners.stopped) listener(new EngineError(data.stopped.error, data.stopped.kind));
        } else {
            const { resolve, reject } = this.calls.get(data.id);
            this.calls.delete(data.id);
            if (data.failure) reject(new EngineError(data.failure.error, data.failure.kind));
            else resolve(data.value);
        }
    }

    on(what, listener) {
        this.listeners[what].push(listener);
    }

    /** @returns {Promise<any>} what the engine answers; rejects with EngineError */
    call(name, request = {}) {
        this.last += 1;
        const id = this.last;
        return new Promise((resolve, reject) => {
            this.calls.set(id, { resolve, reject });
            this.worker.postMessage({ id, request: { call: name, ...request } });
        });
    }

    command(command, values = {}) {
        this.worker.postMessage({ command, ...values });
    }
}
