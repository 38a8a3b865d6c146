// An atom is one point, shaded as a sphere in its fragment: a quad each instead of hundreds of triangles, which is what
// makes tens of thousands of atoms move without a GPU.

export const VERTEX = `
precision highp float;
in vec3 position;      // 0..1 of the box
in float shade;        // 0..1 along the palette
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 box;
uniform float radius, pixels;   // of atoms that are not picked; height of the canvas / (2 tan(field of view / 2))
uniform vec2 fog;               // depths between which atoms fade
uniform int picked;
uniform sampler2D palette;
out vec3 colour;
out float faint, ring;
void main() {
    vec4 eye = modelViewMatrix * vec4((position - 0.5) * box, 1.0);
    gl_Position = projectionMatrix * eye;
    ring = gl_VertexID == picked ? 1.0 : 0.0;
    gl_PointSize = 2.0 * mix(radius, 0.62, ring) * pixels / -eye.z;
    colour = texture(palette, vec2(shade * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
    faint = 0.62 * smoothstep(fog.x, fog.y, -eye.z);
}`;

export const FRAGMENT = `
precision mediump float;
in vec3 colour;
in float faint, ring;
uniform vec3 ground, ink;
out vec4 pixel;
void main() {
    vec2 at = gl_PointCoord * 2.0 - 1.0;
    float reach = dot(at, at);
    if (reach > 1.0) discard;
    if (ring * reach > 0.62) { pixel = vec4(ink, 1.0); return; }
    // The light comes from the upper left; its gleam is where the surface mirrors it to the eye.
    float height = sqrt(1.0 - reach);
    float light = 0.42 + 0.58 * max(dot(vec3(at, height), vec3(-0.38, -0.52, 0.765)), 0.0);
    float gleam = max(dot(vec3(at, height), vec3(-0.22, -0.30, 0.928)), 0.0);
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    pixel = vec4(mix(colour * light + 0.25 * gleam, ground, faint), 1.0);
}`;
