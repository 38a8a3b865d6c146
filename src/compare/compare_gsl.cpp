#include "compare/compare_gsl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text_table.hpp"
#include "deck/deck_system.hpp"
#include "integrators/reference_trajectory.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/observables/few_body/few_body.hpp"
#include "model/velocities.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

constexpr Index max_rows = 1000;
constexpr Index rows_on_screen = 20;
constexpr double tolerance = 1e-13;
constexpr double coarser_tolerance = 1e-12;

std::string in_words(double error) {
    return fmt::format("{:.3e}", error);
}

double largest_distance(const ConstVectorView& a, const ConstVectorView& b) {
    return (a - b).colwise().norm().maxCoeff();
}

/// Runs the deck together with two references and records the differences.
class Comparer : private StepObserver {
  public:
    Comparer(const Deck& deck, RunListener& listener)
        : deck_(deck),
          listener_(listener),
          system_(make_few_body_system(deck.few_bodies())),
          forces_(system_.force.options->make()),
          reference_(system_.state, *forces_, tolerance),
          coarser_(system_.state, *forces_, coarser_tolerance),
          every_(std::max<Index>(1, (total_steps(deck.stages()) + max_rows - 1) / max_rows)) {}

    GslComparison run() {
        run_stages(deck_.stages(), system_.state, *system_.force_field, {*this});
        return comparison_;
    }

  private:
    void started(const Evaluation& evaluation) override {
        energy_ = energy(system_.state, evaluation);
        angular_momentum_ = angular_momentum(system_.state);
        note(evaluation);
    }
    void stage_begins(const Stage& stage) override { listener_.stage_begins(stage); }

    /// Rows are recorded at up to a thousand steps; energy and angular momentum are checked at every step.
    [[nodiscard]] bool wants_energy(Index) const override { return true; }

    void step_done(const Stage&, const Evaluation& evaluation) override {
        const State& state = system_.state;
        watch(evaluation);
        if (state.step % every_ == 0 || state.step == total_steps(deck_.stages())) {
            note(evaluation);
        }
        listener_.step_done(state.step);
    }

    [[nodiscard]] static double energy(const State& state, const Evaluation& evaluation) {
        return evaluation.potential_energy + kinetic_energy(state);
    }

    void watch(const Evaluation& evaluation) {
        comparison_.largest_energy_error =
            std::max(comparison_.largest_energy_error, std::abs(energy(system_.state, evaluation) - energy_));
        comparison_.largest_angular_momentum_error = std::max(
            comparison_.largest_angular_momentum_error, (angular_momentum(system_.state) - angular_momentum_).norm());
    }

    void note(const Evaluation& evaluation) {
        const State& now = system_.state;
        State exact = reference_.advance_to(now.time);
        const State& coarser = coarser_.advance_to(now.time);
        const ConstVectorView r = static_cast<const State&>(exact).positions();
        comparison_.rows.push_back({now.step, now.time, largest_distance(now.positions(), r),
                                    largest_distance(now.velocities(), static_cast<const State&>(exact).velocities()),
                                    std::abs(energy(now, evaluation) - energy_),
                                    (angular_momentum(now) - angular_momentum_).norm(),
                                    largest_distance(coarser.positions(), r)});
        comparison_.largest_position_error =
            std::max(comparison_.largest_position_error, comparison_.rows.back().position_error);
        const Evaluation reference = forces_->evaluate(exact, Request::forces_and_energy);
        depth_ = std::max(depth_, std::abs(reference.potential_energy));
        off_ = std::max(off_, std::abs(energy(exact, reference) - energy_));
        comparison_.reference_energy_error = depth_ > 0.0 ? off_ / depth_ : off_;
    }

    const Deck& deck_;
    RunListener& listener_;
    FewBodySystem system_;
    std::unique_ptr<ForceField> forces_;
    ReferenceTrajectory reference_;
    ReferenceTrajectory coarser_;
    Index every_;
    double energy_ = 0.0;  ///< at the start
    Vec3 angular_momentum_ = Vec3::Zero();
    double depth_ = 0.0;  ///< largest |potential energy| of the reference
    double off_ = 0.0;    ///< largest error of its energy
    GslComparison comparison_;
};

}  // namespace

GslComparison compare_with_gsl(const Deck& deck, RunListener& listener) {
    require_few_bodies(deck, fmt::format("{} is the deck of a fluid, whose motion is too chaotic to be followed; "
                                         "'gsl' compares few-body decks, 'openmm' and 'lammps' fluids",
                                         deck.path));
    for (const Stage& stage : deck.stages()) {
        if (stage.reverse) {
            throw InputError(
                fmt::format("stage '{}' runs backwards; the comparison with gsl goes forward only", stage.name));
        }
    }
    return Comparer(deck, listener).run();
}

std::string comparison_table(const GslComparison& comparison, const Deck& deck) {
    using Align = TextTable::Align;
    constexpr std::size_t width = 12;
    TextTable table({{"time", Align::right, 12},
                     {"position", Align::right, width},
                     {"velocity", Align::right, width},
                     {"energy", Align::right, width},
                     {"ang. momentum", Align::right, width},
                     {"reference", Align::right, width}});
    const auto count = static_cast<Index>(comparison.rows.size());
    const Index stride = std::max<Index>(1, (count + rows_on_screen - 1) / rows_on_screen);
    for (Index k = 0; k < count; ++k) {
        if (k % stride == 0 || k + 1 == count) {
            const auto& row = comparison.rows[static_cast<std::size_t>(k)];
            table.add({fmt::format("{:.6g}", row.time), in_words(row.position_error), in_words(row.velocity_error),
                       in_words(row.energy_error), in_words(row.angular_momentum_error),
                       fmt::format("{:.1e}", row.reference_error)});
        }
    }
    table.add({"largest", in_words(comparison.largest_position_error), "", in_words(comparison.largest_energy_error),
               in_words(comparison.largest_angular_momentum_error)});
    const std::string text = fmt::format("{}\nagainst GSL's adaptive Runge-Kutta method of order 8 (rk8pd)\n\n{}\n",
                                         title_line(deck), table.text());
    return text + fmt::format(
                      "errors are absolute, in the deck's units; reference: distance between two references of "
                      "tolerances {:.0e} and {:.0e}\nthe reference conserves its energy to {:.1e} (at most {:.0e})\n",
                      tolerance, coarser_tolerance, comparison.reference_energy_error,
                      comparison.reference_energy_tolerance);
}

std::string comparison_json(const GslComparison& comparison, const Deck& deck) {
    Data rows = Data::list();
    for (const auto& row : comparison.rows) {
        rows.push_back({{"step", row.step},
                        {"time", row.time},
                        {"position_error", row.position_error},
                        {"velocity_error", row.velocity_error},
                        {"energy_error", row.energy_error},
                        {"angular_momentum_error", row.angular_momentum_error},
                        {"reference_error", row.reference_error}});
    }
    const Data json = {{"deck", deck.path},
                       {"with", "gsl"},
                       {"checks", Data::list({{{"name", "the reference conserves its energy"},
                                               {"value", comparison.reference_energy_error},
                                               {"tolerance", comparison.reference_energy_tolerance},
                                               {"passed", comparison.passed()}}})},
                       {"passed", comparison.passed()},
                       {"largest_position_error", comparison.largest_position_error},
                       {"largest_energy_error", comparison.largest_energy_error},
                       {"largest_angular_momentum_error", comparison.largest_angular_momentum_error},
                       {"rows", rows}};
    return to_json(json);
}

void write_comparison(const GslComparison& comparison, const Deck& deck, const std::filesystem::path& directory,
                      bool force) {
    const Replacing allowed{.force = force, .instead = another_directory};
    make_directory(directory);
    DataTable table{"compare-gsl",
                    {"step", "time", "position_error", "velocity_error", "energy_error", "angular_momentum_error",
                     "reference_error"},
                    {}};
    for (const auto& row : comparison.rows) {
        table.rows.push_back({static_cast<double>(row.step), row.time, row.position_error, row.velocity_error,
                              row.energy_error, row.angular_momentum_error, row.reference_error});
    }
    write_output(directory / "compare-gsl.csv", allowed, to_csv(table));
    write_output(directory / "compare-gsl.json", allowed, comparison_json(comparison, deck) + "\n");
}

}  // namespace ljmd
