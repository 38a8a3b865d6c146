#include "observables/dynamics/scattering.hpp"
#include "observables/transport/long_times.hpp"
#include "observables/transport/time_origins.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {

namespace {

constexpr UsualLags usual_scattering_lags{.every = 10, .max_time = 4.0, .share = 0.1};

struct ScatteringOptions : AnalysisOptions {
    LagOptions lags{usual_scattering_lags};
    std::optional<double> k_min = {};
    double k_max = 7.0;
    Index shells = 7;
    Index vectors = 3;
    LongTimeOption long_times;
    Index origins = 4;  // more cost memory traffic, and add little: the average is over all atoms, too

    void describe(Description& description) override {
        lags.describe(description);
        description.number("k_min", k_min)
            .unit("1/sigma")
            .above(0.0)
            .optional("2 pi/L, the smallest that the box allows")
            .meaning("smallest wave number");
        description.number("k_max", k_max).unit("1/sigma").above(0.0).at_most(100.0).meaning("largest wave number");
        description.integer("shells", shells)
            .at_least(1)
            .at_most(1000)
            .meaning("wave numbers, equally spaced from `k_min` to `k_max`; the nearest that the box allows are taken");
        description.integer("vectors", vectors)
            .at_least(1)
            .at_most(1000)
            .meaning("wave vectors of each wave number, over which is averaged");
        description.integer("origins", origins)
            .at_least(1)
            .at_most(100000)
            .meaning("time origins of F_s within `max_time`; each takes 16 bytes an atom and wave vector");
        long_times.describe(description);
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits misfits = lags.check(run, "scattering");
        const double least = smallest_wave_number(run.box);
        if (k_max < k_min.value_or(least)) {
            misfits.emplace_back("k_max",
                                 fmt::format("'k_max' in scattering is {:.6g}, but the smallest wave number is "
                                             "{:.6g}",
                                             k_max, k_min.value_or(least)));
        }
        long_times.check(lags.times(run), run, "scattering", misfits);
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return with_long_times(long_times, lags.times(run), [&](const LagTimes& times) {
            return std::make_unique<Scattering>(run.atoms, static_cast<double>(run.atoms) / run.box.volume(),
                                                shells_in(run.box), times, correlation_window(times, run), origins);
        });
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const std::vector<WaveShell> made = shells_in(run.box);
        const auto waves = static_cast<Index>(made.size());
        double all_vectors = 0.0;
        for (const WaveShell& shell : made) {
            all_vectors += static_cast<double>(shell.vectors.size());
        }
        return with_long_times_size(long_times, lags.times(run), [&](const LagTimes& times) -> AnalysisSize {
            const Index window = correlation_window(times, run);
            const Index frames = run.steps / times.every + 1;
            const Index between = frames_between_origins(times, origins);
            const Index added = std::max((frames - times.count) / between, Index{0});
            const Index open_origins = (std::min(frames, times.count) + between - 1) / between;
            const double phases = 16.0 * all_vectors * static_cast<double>(run.atoms);
            const auto averages = [&](Index functions, Index samples) {
                return BlockingAccumulator::bytes(functions * waves * (times.count + 1), Covariance::diagonal, samples);
            };
            return {.kept = static_cast<double>(open_origins) * phases +
                            64.0 * all_vectors * static_cast<double>(std::min(frames, window)) +
                            averages(4, frames / window) + averages(1, added) +
                            Scattering::bytes_of_modes(waves, times, frames / window, added),
                    .passing = phases};
        });
    }

  private:
    [[nodiscard]] std::vector<WaveShell> shells_in(const Box& box) const {
        return wave_shells(box, k_min.value_or(std::min(smallest_wave_number(box), k_max)), k_max, shells, vectors);
    }
};

}  // namespace

/// Scattering functions, see dynamics/scattering.hpp.
AnalysisMethod scattering() {
    return {
        .name = "scattering",
        .meaning =
            "intermediate scattering functions F(k, t) and F_s(k, t), longitudinal and transverse currents, dynamic "
            "structure factor S(k, omega), sound, viscosity and diffusion at these wave numbers, written to fkt.csv, "
            "fskt.csv, skw.csv and modes.csv",
        .files = {"fkt", "fskt", "skw", "modes"},
        .follows_time = true,
        .needs = {.velocities = true, .unwrapped_positions = true},
        .quantities = {{"k", "k sigma", ""},
                       {"F", "F(k, t)", ""},
                       {"C_L", "C_L(k, t)", "tau^-2"},
                       {"C_T", "C_T(k, t)", "tau^-2"},
                       {"F_s", "F_s(k, t)", ""},
                       {"angular_frequency", "omega tau", ""},
                       {"S_kw", "S(k, omega)", "tau"},
                       {"sound_velocity", "c(k)", "sigma/tau"},
                       {"sound_attenuation", "Gamma(k)", "sigma^2/tau"},
                       {"transverse_viscosity", "eta(k)", "epsilon tau/sigma^3"},
                       {"self_diffusion", "D(k)", "sigma^2/tau"}},
        .charts =
            {{.file = "fkt", .x = "time", .y = "F", .title = "Intermediate scattering, by wave number", .group = "k"},
             {.file = "fskt", .x = "time", .y = "F_s", .title = "Its self part, by wave number", .group = "k"},
             {.file = "fkt", .x = "time", .y = "C_L", .title = "Longitudinal current, by wave number", .group = "k"},
             {.file = "fkt", .x = "time", .y = "C_T", .title = "Transverse current, by wave number", .group = "k"},
             {.file = "skw",
              .x = "angular_frequency",
              .y = "S_kw",
              .title = "Dynamic structure factor, by wave number",
              .group = "k"},
             {.file = "modes",
              .x = "k",
              .y = "sound_velocity",
              .title = "Speed of sound, by wave number",
              .as_dots = true},
             {.file = "modes",
              .x = "k",
              .y = "sound_attenuation",
              .title = "Attenuation of sound, by wave number",
              .as_dots = true},
             {.file = "modes",
              .x = "k",
              .y = "transverse_viscosity",
              .title = "Viscosity, by wave number",
              .as_dots = true},
             {.file = "modes", .x = "k", .y = "self_diffusion", .title = "Diffusion, by wave number", .as_dots = true}},
        .options = [] { return std::make_unique<ScatteringOptions>(); }};
}

}  // namespace ljmd
