// A deck in the fragment of the page's address, packed. What comes in is a text for the parser of decks, and nothing else.
const MOST = 200_000;   // characters of a fragment; of a deck in it

async function through(stream, bytes) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

/** @param {{deck: string, name: string}} what */
export async function fragmentOf(what) {
    const packed = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(what)));
    const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(""));
    return `#deck=${letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** Unpacks no more than so many bytes: a short fragment can unpack to any length. */
async function unpacked(bytes) {
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
    const parts = [];
    let length = 0;
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
        length += part.value.length;
        if (length > MOST) throw new Error("the deck in this link is longer than a deck may be");
        parts.push(part.value);
    }
    return new TextDecoder().decode(await new Blob(parts).arrayBuffer());
}

/** The deck of an address, null if it has none. @throws Error in words for whoever opened the link */
export async function deckOf(fragment) {
    const found = /^#(?:.*&)?deck=([A-Za-z0-9_-]*)/.exec(fragment);
    if (!found) {
        if (fragment.startsWith("#deck=")) throw new Error("this link is damaged");
        return null;
    }
    if (fragment.length > MOST) throw new Error("this link is longer than a link may be");
    let what;
    try {
        const letters = atob(found[1].replaceAll("-", "+").replaceAll("_", "/"));
        what = JSON.parse(await unpacked(Uint8Array.from(letters, (letter) => letter.charCodeAt(0))));
    } catch (error) {
        throw error.message.includes("longer") ? error : new Error("this link is damaged", { cause: error });
    }
    if (typeof what?.deck !== "string") throw new Error("this link holds no deck");
    return { deck: what.deck, name: typeof what.name === "string" ? what.name.slice(0, 100) : "link.toml" };
}
