// Draws atoms with WebGL: one call for all of them, see shaders.js.
import {
    BufferAttribute, BufferGeometry, Color, DataTexture, GLSL3, Group, LineBasicMaterial, LineSegments, PerspectiveCamera, Points,
    RawShaderMaterial, RGBAFormat, Scene, Uint8BufferAttribute, Vector2, Vector3, WebGLRenderer,
} from "three";
import { viridis } from "../palette.js";
import { FRAGMENT, VERTEX } from "./shaders.js";

const SLICES = 1024;
const EDGES = [0, 1, 1, 3, 3, 2, 2, 0, 4, 5, 5, 7, 7, 6, 6, 4, 0, 4, 1, 5, 2, 6, 3, 7];

function paletteTexture() {
    const texels = new Uint8Array(256 * 4);
    for (let place = 0; place < 256; ++place) texels.set([...viridis(place / 255), 255], 4 * place);
    const texture = new DataTexture(texels, 256, 1, RGBAFormat);
    texture.needsUpdate = true;
    return texture;
}

/** A random order of the atoms, the same on every page: its first n are a fair sample. */
function shuffled(count) {
    const order = Uint32Array.from({ length: count }, (_, atom) => atom);
    let state = 12345;
    for (let place = count - 1; place > 0; --place) {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        const other = state % (place + 1);
        [order[place], order[other]] = [order[other], order[place]];
    }
    return order;
}

export class AtomScene {
    /** @param {HTMLCanvasElement} canvas @param {number} count of atoms; throws where there is no WebGL 2 */
    constructor(canvas, count) {
        const context = canvas.getContext("webgl2", { antialias: false, alpha: false, powerPreference: "high-performance" });
        if (!context) throw new Error("this browser offers no WebGL 2");
        this.renderer = new WebGLRenderer({ canvas, context, antialias: false });
        this.canvas = canvas;
        this.count = count;
        this.scene = new Scene();
        this.camera = new PerspectiveCamera();
        this.geometry = new BufferGeometry();
        this.geometry.setAttribute("position", new BufferAttribute(new Uint16Array(3 * count), 3, true));
        this.geometry.setAttribute("shade", new Uint8BufferAttribute(new Uint8Array(count), 1, true));
        this.order = shuffled(count);
        this.slices = new Uint16Array(count);
        this.geometry.setIndex(new BufferAttribute(this.order.slice(), 1));
        this.uniforms = {
            box: { value: new Vector3() }, radius: { value: 0.5 }, pixels: { value: 1 }, fog: { value: new Vector2() },
            picked: { value: -1 }, palette: { value: paletteTexture() }, ground: { value: new Color() }, ink: { value: new Color() },
        };
        const material = new RawShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, glslVersion: GLSL3, uniforms: this.uniforms });
        this.points = new Points(this.geometry, material);
        this.points.frustumCulled = false;
        this.edges = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
        this.edges.geometry.setIndex(EDGES);
        this.trace = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
        this.trace.renderOrder = 1;
        this.group = new Group();
        this.group.add(this.points, this.edges, this.trace);
        this.scene.add(this.group);
    }

    /** Positions of a frame, as fractions of the box times 65536. */
    setFrame(positions, box) {
        const attribute = this.geometry.getAttribute("position");
        attribute.array.set(positions);
        attribute.needsUpdate = true;
        if (this.uniforms.box.value.toArray().some((edge, axis) => edge !== box[axis])) this.setBox(box);
    }

    setBox(box) {
        this.uniforms.box.value.fromArray(box);
        const corners = new Float32Array(24);
        for (let corner = 0; corner < 8; ++corner) {
            for (let axis = 0; axis < 3; ++axis) corners[3 * corner + axis] = ((corner >> axis) & 1 ? 0.5 : -0.5) * box[axis];
        }
        this.edges.geometry.setAttribute("position", new BufferAttribute(corners, 3));
    }

    setShades(values) {
        const attribute = this.geometry.getAttribute("shade");
        attribute.array.set(values);
        attribute.needsUpdate = true;
    }

    /** @param {Float32Array} ends pairs of points */
    setTrace(ends) {
        this.trace.geometry.dispose();
        this.trace.geometry = new BufferGeometry();
        this.trace.geometry.setAttribute("position", new BufferAttribute(ends, 3));
    }

    /** @param {{ground: string, ink: string, edge: string, trace: string}} colours as CSS */
    setColours({ ground, ink, edge, trace }) {
        // The shader writes colours as the page shows them; lines go through three's conversion.
        this.uniforms.ground.value.setStyle(ground, "srgb-linear");
        this.uniforms.ink.value.setStyle(ink, "srgb-linear");
        this.scene.background = new Color(ground);
        this.edges.material.color.set(edge);
        this.trace.material.color.set(trace);
    }

    /**
     * The nearest come first, so that the depth test leaves out what they hide before it is shaded: half of the work of
     * a picture. A counting sort over slices of depth.
     */
    sortNearestFirst(view, drawn) {
        const { array } = this.geometry.getAttribute("position");
        const index = this.geometry.getIndex();
        const [x, y, z] = view.axes()[2].map((part, axis) => -part * this.uniforms.box.value.getComponent(axis));
        const near = Math.min(0, x) + Math.min(0, y) + Math.min(0, z);
        const slices = SLICES / 65536 / (Math.abs(x) + Math.abs(y) + Math.abs(z));
        const starts = new Uint32Array(SLICES + 1);
        for (let place = 0; place < drawn; ++place) {
            const atom = this.order[place];
            const slice = Math.floor((x * array[3 * atom] + y * array[3 * atom + 1] + z * array[3 * atom + 2] - 65536 * near) * slices);
            this.slices[place] = slice;
            starts[slice + 1] += 1;
        }
        for (let slice = 0; slice < SLICES; ++slice) starts[slice + 1] += starts[slice];
        for (let place = 0; place < drawn; ++place) index.array[starts[this.slices[place]]++] = this.order[place];
        index.needsUpdate = true;
    }

    setSize(width, height, ratio) {
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
    }

    /** @param {import("./camera.js").Camera} view @param {number} drawn atoms, a sample where it is fewer than all */
    draw(view, drawn) {
        const { width, height } = this.canvas;
        view.applyTo(this.camera, width / height);
        const distance = view.distance(width / height);
        this.uniforms.pixels.value = height / 2 / Math.tan((this.camera.fov * Math.PI) / 360);
        this.uniforms.fog.value.set(distance - view.radius * 0.7, distance + view.radius * 1.1);
        this.sortNearestFirst(view, drawn);
        this.geometry.setDrawRange(0, drawn);
        this.renderer.render(this.scene, this.camera);
    }
}
