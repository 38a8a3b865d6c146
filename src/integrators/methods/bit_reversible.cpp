#include "execution/loops.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr const char* last_displacement = "bit-reversible: displacement of the last step";

/// Spacing of the position grid without a box. Doubles hold its multiples exactly up to `far_out`.
constexpr double unbounded_resolution = 0x1p-44;
constexpr double far_out = 0x1p7;

/// x rounded to the grid. Adding and subtracting 1.5 * 2^52 spacings rounds to the nearest multiple.
Vec3 on_grid(const Vec3& x, double resolution) {
    const double rounding = 0x1.8p52 * resolution;
    return (x.array() + rounding) - rounding;
}

double resolution_of(const State& state) {
    return state.has_box() ? state.box().resolution() : unbounded_resolution;
}

Vec3 increment(const State& state, Index i, double dt) {
    const double dt2_over_m = dt * dt / state.masses()[static_cast<std::size_t>(i)];
    return on_grid(dt2_over_m * state.forces().col(i), resolution_of(state));
}

/// Verlet's Taylor start, with the displacement rounded to the grid.
void begin(State& state, double dt) {
    auto d = state.registered(state.register_vectors(last_displacement));
    const auto v = state.velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        const Vec3 half_increment = 0.5 * dt * dt / state.masses()[static_cast<std::size_t>(i)] *
                                    static_cast<const State&>(state).forces().col(i);
        d.col(i) = on_grid(dt * v.col(i) - half_increment, resolution_of(state));
    });
}

void put_on_grid(State& state) {
    if (!state.has_box()) {
        auto r = state.write_positions();
        for_each_index(state.execution(), state.count(),
                       [&](Index i) { r.col(i) = on_grid(r.col(i), unbounded_resolution); });
    }
}

/// Sums and differences of multiples of the grid spacing are exact here, as with integers.
void advance(State& state, double dt) {
    auto d = state.registered(state.register_vectors(last_displacement));
    for_each_index(state.execution(), state.count(), [&](Index i) { d.col(i) += increment(state, i, dt); });
    auto r = state.write_positions();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        r.col(i) += d.col(i);
        if (!state.has_box() && !(r.col(i).cwiseAbs().maxCoeff() < far_out)) {
            throw PhysicsError(
                "a body is more than 128 length units from the origin, beyond the exact grid of the "
                "bit-reversible integrator: choose a larger unit of length");
        }
    });
}

void central_difference(State& state, double dt) {
    const auto d = state.registered(state.register_vectors(last_displacement));
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { v.col(i) = (2.0 * d.col(i) + increment(state, i, dt)) / (2.0 * dt); });
}

void reverse(State& state, double dt) {
    auto d = state.registered(state.register_vectors(last_displacement));
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { d.col(i) = -(d.col(i) + increment(state, i, dt)); });
    state.write_velocities() *= -1.0;
}

}  // namespace

/// Bit-reversible leapfrog: Verlet's formula on integer positions.
///
///     r(t + dt) = 2 r(t) - r(t - dt) + [(dt^2/m) f(t)]
///
/// where positions are multiples of a grid spacing (the box's, about one unit in the last place of its edge;
/// 2^-44 without a box) and [ ] rounds to multiples. Sums are exact, so r(t - dt) follows from r(t) and r(t + dt) to
/// the last bit: n steps forwards and n steps back end at the start, however chaotic the motion. On the way back the
/// forces must be the same function of the positions, whatever the order of the atoms in memory, so they are summed in
/// fixed point. Velocities are central differences. Second order, symplectic. Source: Levesque and Verlet (1993), J.
/// Stat. Phys. 72, 519
IntegratorMethod bit_reversible() {
    return {
        .name = "bit-reversible",
        .meaning = "Verlet's formula on integer positions: returns to its start bit for bit (Levesque and Verlet 1993)",
        .order = 2,
        .reversible = true,
        .options = without_options([](double dt) -> Scheme {
            const Evaluate forces{.order_independent = true};
            const Update difference{[dt](State& state) { central_difference(state, dt); }};
            return {
                .begin = {Update{put_on_grid}, forces, Update{[dt](State& state) { begin(state, dt); }}, difference},
                .cycle = {{Update{[dt](State& state) { advance(state, dt); }, dt}, forces, difference}},
                .reverse = {Update{[dt](State& state) { reverse(state, dt); }}}};
        })};
}

}  // namespace ljmd
