// A camera that circles around the middle of what it shows, in perspective. Both drawings, WebGL and canvas, use it.

const FIELD_OF_VIEW = (35 * Math.PI) / 180;
const FLAT = Math.PI / 2 - 0.01;

export class Camera {
    /** @param {number} radius of the sphere that is to be seen whole @param {{azimuth: number, elevation: number}} from */
    constructor(radius, from = { azimuth: 0.6, elevation: 0.35 }) {
        this.radius = radius;
        this.from = from;
        this.reset();
    }

    reset() {
        this.azimuth = this.from.azimuth;
        this.elevation = this.from.elevation;
        this.zoom = 1;
    }

    turn(right, up) {
        this.azimuth += right;
        this.elevation = Math.min(Math.max(this.elevation + up, -FLAT), FLAT);
    }

    scale(factor) {
        this.zoom = Math.min(Math.max(this.zoom * factor, 0.3), 12);
    }

    /** Distance to the middle, in units of what is shown. */
    distance(aspect) {
        const narrow = Math.min(1, aspect);
        return this.radius / Math.sin(Math.atan(Math.tan(FIELD_OF_VIEW / 2) * narrow)) / this.zoom;
    }

    /** Right, up and towards the eye, as rows. */
    axes() {
        const [sa, ca, se, ce] = [Math.sin(this.azimuth), Math.cos(this.azimuth), Math.sin(this.elevation), Math.cos(this.elevation)];
        return [[ca, 0, -sa], [-sa * se, ce, -ca * se], [sa * ce, se, ca * ce]];
    }

    /** @returns {(x: number, y: number, z: number) => number[]} pixel x and y, depth (far is large), pixels a unit there */
    projection(width, height) {
        const [right, up, eye] = this.axes();
        const distance = this.distance(width / height);
        const focal = height / 2 / Math.tan(FIELD_OF_VIEW / 2);
        return (x, y, z) => {
            const depth = distance - (x * eye[0] + y * eye[1] + z * eye[2]);
            const pixels = depth > 0 ? focal / depth : 0;
            return [width / 2 + pixels * (x * right[0] + y * right[1] + z * right[2]),
                height / 2 - pixels * (x * up[0] + y * up[1] + z * up[2]), depth, pixels];
        };
    }

    /** Sets a camera of three.js. */
    applyTo(camera, aspect) {
        const eye = this.axes()[2];
        const distance = this.distance(aspect);
        camera.fov = (FIELD_OF_VIEW * 180) / Math.PI;
        camera.aspect = aspect;
        camera.near = Math.max(distance - 2 * this.radius, 0.01 * this.radius);
        camera.far = distance + 2 * this.radius;
        camera.position.set(eye[0] * distance, eye[1] * distance, eye[2] * distance);
        camera.lookAt(0, 0, 0);
        camera.updateProjectionMatrix();
    }
}
