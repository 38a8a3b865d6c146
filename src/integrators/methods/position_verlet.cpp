#include "execution/loops.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

/// r(t) - r(t - dt). A displacement rather than the old position, because wrapping an atom does not change it.
constexpr const char* last_displacement = "position-verlet: displacement of the last step";

/// The displacement before the first step, chosen so that the first step is the one prescribed by `start`.
void begin(State& state, double dt, const std::string& start) {
    auto d = state.registered(state.register_vectors(last_displacement));
    const State& now = state;
    const auto v = now.velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        const Vec3 dt2_a = dt * dt / state.masses()[static_cast<std::size_t>(i)] * now.forces().col(i);
        const Vec3 dt_v = dt * v.col(i);
        const Vec3 r = now.positions().col(i);
        if (start == "euler") {
            d.col(i) = dt_v - dt2_a;
        } else if (start == "taylor") {
            d.col(i) = (dt_v + 0.5 * dt2_a) - dt2_a;
        } else {
            d.col(i) = r - state.snapped(r - dt_v + 0.5 * dt2_a);
        }
    });
}

/// d becomes r(t + dt) - r(t), exactly, as both lie on the grid of the box.
void advance(State& state, double dt) {
    auto d = state.registered(state.register_vectors(last_displacement));
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        const Vec3 dt2_a = dt * dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
        const Vec3 r_old = r.col(i);
        r.col(i) = state.snapped(r_old + (d.col(i) + dt2_a));
        d.col(i) = r.col(i) - r_old;
    });
}

/// (r(t + dt) - r(t - dt)) / 2 dt with r(t + dt) - r(t) = d + dt^2 a, so that no step ahead is needed.
void central_difference(State& state, double dt) {
    const auto d = state.registered(state.register_vectors(last_displacement));
    const auto f = static_cast<const State&>(state).forces();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        v.col(i) = d.col(i) / dt + 0.5 * dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
    });
}

/// Backwards in time, r(t + dt) is the position before r(t).
void reverse(State& state, double dt) {
    auto d = state.registered(state.register_vectors(last_displacement));
    const auto f = static_cast<const State&>(state).forces();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        d.col(i) = -(d.col(i) + dt * dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i));
    });
    state.write_velocities() *= -1.0;
}

struct Options : IntegratorOptions {
    std::string start = "taylor";

    void describe(Description& description) override {
        description.choice("start", {"taylor", "backward", "euler"}, start)
            .meaning(
                "how the second position is found: taylor and backward to second order, euler to first, "
                "which makes the whole run first order");
    }
    [[nodiscard]] Scheme scheme(double dt) const override {
        return {.begin = {Update{[dt, how = start](State& state) { begin(state, dt, how); }}},
                .cycle = {{Update{[dt](State& state) { advance(state, dt); }, dt}, Evaluate{},
                           Update{[dt](State& state) { central_difference(state, dt); }}}},
                .reverse = {Update{[dt](State& state) { reverse(state, dt); }}}};
    }
};

}  // namespace

/// Verlet's formula of 1967, found earlier by Störmer, for positions alone:
///
///     r(t + dt) = 2 r(t) - r(t - dt) + (dt^2/m) f(t)
///     v(t)      = (r(t + dt) - r(t - dt)) / 2 dt
///
/// computed in the summed form r(t + dt) = r(t) + d, d = r(t) - r(t - dt) + (dt^2/m) f(t), which avoids cancellation.
/// The start needs a second position:
///
///     taylor    r(dt)  = r(0) + dt v(0) + (dt^2/2m) f(0)
///     backward  r(-dt) = r(0) - dt v(0) + (dt^2/2m) f(0), the same within rounding
///     euler     r(dt)  = r(0) + dt v(0), which makes the whole run first order, with another initial velocity
///
/// Second order, time-reversible, symplectic. Unless started by Euler, it has velocity Verlet's positions within
/// rounding.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98, equations 4 and 5; Störmer (1907), Arch. Sci. Phys. Nat. 24, 5
IntegratorMethod position_verlet() {
    return {.name = "position-verlet",
            .meaning = "Verlet's formula of 1967 for positions alone, velocities by central differences (Störmer 1907)",
            .order = 2,
            .reversible = true,
            .options = [] { return std::make_unique<Options>(); }};
}

}  // namespace ljmd
