#include "judge/row_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "judge/explanations.hpp"
#include "judge/few_digits.hpp"

namespace ljmd {

namespace {

constexpr double fastest_motion_of_rows = 40.0;  // [1/tau], see velocity_limit()
constexpr double virial_over_force = 20.0;       // r u'' over u' of a pair, at most
constexpr double unexplained_of_rows = 1e-2;
constexpr double unexplained_by_a_parameter = 1e-6;  // energies hardly change: any constant or factor explains much
constexpr std::size_t rows_for_a_parameter = 3;      // fewer are met by any constant

using Value = std::function<double(const OwnRow&)>;

/// A column, and what it is to be.
struct Column {
    const char* name;
    const std::vector<double>& values;
    Value right;
    Value size;                   ///< of the terms that it is the sum of
    double sensitivity;           ///< of it to energies
    bool has_half_steps = false;  ///< whether velocities of another time may be in it
    double tail = 0.0;            ///< that is in it
    Value with_freedom = {};      ///< it with a temperature of 3 N - 3 degrees of freedom in the place of 2 K
    Value without_motion = {};    ///< it without its kinetic part
};

/// One column in the rows that are compared.
class ColumnJudgement {
  public:
    ColumnJudgement(const Column& column, const ThermoAnswer& table, const std::vector<OwnRow>& ours,
                    const RowConditions& conditions)
        : column_(column), ours_(ours), every_(conditions.thermo_every) {
        double kinetic = 0.0;
        for (const OwnRow& row : ours) {
            kinetic = std::max(kinetic, row.kinetic_energy);
        }
        const auto atoms = static_cast<double>(conditions.atoms);
        const double energy_per_distance = fastest_motion_of_rows * std::sqrt(2.0 * kinetic * atoms);
        for (std::size_t k = 0; k < table.steps.size(); ++k) {
            const Index step = table.steps[k];
            const auto distance = limit_at(conditions.agreement.positions, step);
            if (step < 1 || step + 1 >= std::ssize(ours) || !distance) {
                continue;
            }
            const double size = column.size(row(step));
            rows_.push_back({step, column.values[k],
                             std::max(conditions.digits * size, column.sensitivity * energy_per_distance * *distance)});
        }
    }

    void judge(RowJudgement& result) const {
        if (rows_.empty()) {
            return;
        }
        const auto excess = [&](const Row& of) { return std::abs(of.value - column_.right(row(of.step))) / of.noise; };
        const auto worst = std::ranges::max_element(rows_, {}, excess);
        const double size = column_.size(row(worst->step));
        result.checks.push_back(
            {fmt::format("thermo.csv, steps {} to {}: {}", rows_.front().step, rows_.back().step, column_.name),
             excess(*worst) * worst->noise / size, worst->noise / size});
        if (!result.checks.back().passed()) {
            result.checks.back().name += fmt::format(", worst at {}", worst->step);
            explain(result);
        }
    }

  private:
    struct Row {
        Index step;
        double value;
        double noise;
    };

    [[nodiscard]] const OwnRow& row(Index step) const { return ours_[static_cast<std::size_t>(step)]; }

    [[nodiscard]] double distance(const std::function<double(Index)>& meant) const {
        double squares = 0.0;
        for (const Row& of : rows_) {
            squares += std::pow(of.value - meant(of.step), 2);
        }
        return std::sqrt(squares);
    }

    void explain(RowJudgement& result) const {
        double noise = 0.0;
        for (const Row& of : rows_) {
            noise = std::hypot(noise, of.noise);
        }
        const auto right = [&](Index step) { return column_.right(row(step)); };
        const double off = distance(right);
        Explanations known(off, noise, unexplained_of_rows);
        const std::string column = fmt::format("the {} of thermo.csv", column_.name);
        for (const Index shift : {Index{-1}, Index{1}, -every_, every_}) {
            const bool is_inside = rows_.front().step + shift >= 0 && rows_.back().step + shift < std::ssize(ours_);
            if (is_inside) {
                known.offer(
                    distance([&](Index step) { return right(step + shift); }),
                    fmt::format("{} {}: {} is that of {} step{} {} than the row says",
                                std::abs(shift) == 1 ? "one step" : "one row", shift < 0 ? "late" : "early", column,
                                std::abs(shift), std::abs(shift) == 1 ? "" : "s", shift < 0 ? "earlier" : "later"));
            }
        }
        if (column_.has_half_steps) {
            for (const bool after : {false, true}) {
                known.offer(
                    distance([&](Index step) {
                        return after ? row(step).kinetic_energy_after : row(step).kinetic_energy_before;
                    }),
                    fmt::format("half-step velocities: the kinetic energy of thermo.csv is that of velocities half "
                                "a time step {}",
                                after ? "later" : "earlier"));
            }
            known.offer(distance([&](Index step) {
                            return 0.5 * (row(step).kinetic_energy_after + row(step).kinetic_energy_before);
                        }),
                        "half-step velocities: the kinetic energy of thermo.csv is the mean of those half a time step "
                        "earlier and later, as leapfrog gives it");
        }
        if (column_.with_freedom) {
            known.offer(distance([&](Index step) { return column_.with_freedom(row(step)); }),
                        "3N against 3N-3: the pressure of thermo.csv is rho T + W/(3 V) in all rows, each with its T, "
                        "where (2 K + W)/(3 V) is asked for; no mistake in itself");
        }
        for (const Rounding& way : roundings()) {
            known.offer(distance([&](Index step) { return way.round(right(step)); }),
                        fmt::format("few digits: {} has {}", column, way.words));
        }
        if (const auto words = known.best()) {
            result.mistakes.push_back(*words);
        } else if (rows_.size() >= rows_for_a_parameter && !has_constant_motion(off, noise, result)) {
            explain_by_a_parameter(Explanations(off, noise, unexplained_by_a_parameter), column, result);
        }
    }

    /// Whether the kinetic part of a pressure is the same in all rows; then it says so.
    bool has_constant_motion(double off, double noise, RowJudgement& result) const {
        if (!column_.without_motion) {
            return false;
        }
        double motion = 0.0;
        for (const Row& of : rows_) {
            motion += (of.value - column_.without_motion(row(of.step))) / static_cast<double>(rows_.size());
        }
        const OwnRow& first = row(rows_.front().step);
        if (!(motion > 0.01 * (column_.right(first) - column_.without_motion(first)))) {
            return false;  // it has none
        }
        Explanations known(off, noise, unexplained_by_a_parameter);
        known.offer(distance([&](Index step) { return column_.without_motion(row(step)) + motion; }),
                    fmt::format("constant temperature: the {} of thermo.csv has the kinetic part {:.8g} in all rows, "
                                "as of a temperature that is set, where it is to have that of its own time",
                                column_.name, motion));
        if (const auto words = known.best()) {
            result.mistakes.push_back(*words);
            result.has_constant_motion = true;
        }
        return result.has_constant_motion;
    }

    void explain_by_a_parameter(Explanations known, const std::string& column, RowJudgement& result) const {
        double added = 0.0;
        double along = 0.0;
        double squares = 0.0;
        for (const Row& of : rows_) {
            const double right = column_.right(row(of.step));
            added += (of.value - right) / static_cast<double>(rows_.size());
            along += of.value * right;
            squares += right * right;
        }
        const double factor = along / squares;
        known.offer(distance([&](Index step) { return column_.right(row(step)) + added; }),
                    fmt::format("constant: {} has {:.8g} added in all rows{}", column, added,
                                column_.tail == 0.0
                                    ? ""
                                    : fmt::format("; if it is of the tail correction, that would be {:.8g} instead of "
                                                  "{:.8g}: check its formula and its sign",
                                                  column_.tail + added, column_.tail)));
        known.offer(distance([&](Index step) { return column_.right(row(step)) * factor; }),
                    fmt::format("factor: {} is {:.8g} times the right one in all rows", column, factor));
        if (const auto words = known.best()) {
            result.others.push_back(*words);
        }
    }

    const Column& column_;
    const std::vector<OwnRow>& ours_;
    Index every_;
    std::vector<Row> rows_;
};

/// The rows as they are said to be.
RowJudgement judge_said_rows(const ThermoAnswer& table, const std::vector<OwnRow>& ours,
                             const RowConditions& conditions) {
    const auto kinetic = [](const OwnRow& row) { return row.kinetic_energy; };
    const double kinetic_of_start = ours.front().kinetic_energy;
    const double energy_of_start = std::abs(ours.front().potential_energy);
    const double thrice_volume = 3.0 * conditions.volume;
    RowJudgement result;
    for (const Column& column :
         {Column{"potential energy", table.potential_energy, [](const OwnRow& row) { return row.potential_energy; },
                 [&](const OwnRow& row) { return std::max(energy_of_start, std::abs(row.potential_energy)); }, 1.0,
                 false, conditions.tail_energy},
          Column{"kinetic energy", table.kinetic_energy, kinetic,
                 [&](const OwnRow& row) { return std::max(kinetic_of_start, row.kinetic_energy); }, 1.0, true},
          Column{"pressure", table.pressure, [](const OwnRow& row) { return row.pressure; },
                 [&](const OwnRow& row) {
                     return std::abs(row.pressure) +
                            2.0 * std::max(kinetic_of_start, row.kinetic_energy) / thrice_volume;
                 },
                 virial_over_force / thrice_volume, false, conditions.tail_pressure,
                 [&](const OwnRow& row) {
                     return row.pressure +
                            2.0 * row.kinetic_energy / thrice_volume / (static_cast<double>(conditions.atoms) - 1.0);
                 },
                 [&](const OwnRow& row) { return row.pressure - 2.0 * row.kinetic_energy / thrice_volume; }},
          Column{"volume", table.volume, [&](const OwnRow&) { return conditions.volume; },
                 [&](const OwnRow&) { return conditions.volume; }, 0.0}}) {
        if (!column.values.empty()) {
            ColumnJudgement(column, table, ours, conditions).judge(result);
        }
    }
    return result;
}

bool has_failures(const RowJudgement& judged) {
    return std::ranges::any_of(judged.checks, [](const Check& check) { return !check.passed(); });
}

/// Whether steps are 0, 1, 2, ... or 1, 2, 3, ..., where fewer are to be written.
bool may_be_numbers_of_rows(const ThermoAnswer& table, Index every) {
    const Index rows = std::ssize(table.steps);
    return every > 1 && rows > 2 && table.steps.front() <= 1 && table.steps.back() - table.steps.front() == rows - 1;
}

}  // namespace

Index last_compared_step(const ThermoAnswer& table, Index every, Index together) {
    const Index last = *std::prev(std::ranges::upper_bound(table.steps, together));
    return may_be_numbers_of_rows(table, every) ? std::min(together, last * every) : last;
}

RowJudgement judge_rows(const ThermoAnswer& table, const std::vector<OwnRow>& ours, const RowConditions& conditions) {
    RowJudgement judged = judge_said_rows(table, ours, conditions);
    if (has_failures(judged) && may_be_numbers_of_rows(table, conditions.thermo_every)) {
        ThermoAnswer meant = table;
        for (Index& step : meant.steps) {
            step *= conditions.thermo_every;
        }
        const RowJudgement by_number = judge_said_rows(meant, ours, conditions);
        if (!by_number.checks.empty() && !has_failures(by_number)) {
            judged.mistakes = {
                fmt::format("row numbers: the column step of thermo.csv counts rows; its values are "
                            "those of the steps {}, {}, ...",
                            meant.steps[0], meant.steps[1])};
            judged.others.clear();
        }
    }
    return judged;
}

RowJudgement judge_temperatures(const ThermoAnswer& table, Index atoms, Index freedom, double tolerance) {
    RowJudgement result;
    if (table.temperature.empty() || table.kinetic_energy.empty() || freedom == 0) {
        return result;
    }
    const auto largest_with = [&](Index of) {
        double largest = 0.0;
        for (std::size_t k = 0; k < table.steps.size(); ++k) {
            const double right = 2.0 * table.kinetic_energy[k] / static_cast<double>(of);
            largest = larger_or_nan(largest, relative_difference(table.temperature[k], right));
        }
        return largest;
    };
    result.checks.push_back(
        {"thermo.csv: temperature and 2 K/f, largest difference", largest_with(freedom), tolerance});
    for (const auto& [of, name] : {std::pair(3 * atoms, "3N"), std::pair(3 * atoms - 6, "3N-6")}) {
        if (has_failures(result) && of > 0 && largest_with(of) <= tolerance) {
            result.mistakes.push_back(fmt::format(
                "{} against 3N-3: the temperature of thermo.csv is 2 K/{}, where f is {}; a centre of mass at rest "
                "takes three degrees of freedom, and nothing else does in a periodic box",
                name, of, freedom));
        }
    }
    return result;
}

}  // namespace ljmd
