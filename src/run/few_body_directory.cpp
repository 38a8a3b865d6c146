#include "ljmd/run/few_body_directory.hpp"

#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/io/formats/extended_xyz_writer.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/run/few_body_run.hpp"

namespace ljmd {

namespace {

std::optional<TrajectoryCsv> open_csv(const Deck& deck, const FewBodySystem& system, std::optional<std::int64_t> kept) {
    if (!deck.trajectory || deck.trajectory->format != "csv") {
        return std::nullopt;
    }
    return TrajectoryCsv(deck.outputs() / "trajectory.csv", system.state.count(), system.dimensions,
                         deck.trajectory->accelerations, system.force.plugin.has_polar_angle, kept);
}

}  // namespace

FewBodyDirectory::FewBodyDirectory(const Deck& deck, const FewBodySystem& system,
                                   const std::optional<ResumedOutputs>& resumed)
    : deck_(deck),
      csv_(open_csv(deck, system, resumed ? std::optional(resumed->kept.trajectory.bytes) : std::nullopt)),
      trajectory_(
          csv_ ? nullptr
               : open_trajectory(deck, system.state, resumed ? std::optional(resumed->kept.trajectory) : std::nullopt)),
      thermo_(deck.outputs() / "thermo.csv", system.dimensions,
              resumed ? std::optional(resumed->kept.thermo) : std::nullopt),
      record_(deck, resumed ? std::optional(resumed->earlier) : std::nullopt) {}

CommittedOutputs FewBodyDirectory::commit() {
    if (csv_) {
        return {thermo_.commit(), {.bytes = csv_->commit()}};
    }
    return {thermo_.commit(), trajectory_ ? trajectory_->commit() : CommittedFrames()};
}

void FewBodyDirectory::write_thermo(const State& state, const FewBodyTotals& totals) {
    constexpr Index rows_between_flushes = 100;
    thermo_.write(state.step, state.time, totals);
    if (++rows_since_flush_ == rows_between_flushes) {
        thermo_.flush();
        if (csv_) {
            csv_->flush();
        }
        rows_since_flush_ = 0;
    }
}

void FewBodyDirectory::write_frame(const State& state, const std::optional<PolarAngle>& angle) {
    if (csv_) {
        csv_->write(state, angle ? std::optional(angle->value) : std::nullopt);
    } else if (trajectory_) {
        trajectory_->write(state);
    }
}

void FewBodyDirectory::finish(const State& state, const FewBodyResult& result, const std::vector<DataTable>& tables) {
    thermo_.close();
    if (csv_) {
        csv_->close();
    }
    if (trajectory_) {
        trajectory_->close();
    }
    write_configuration(deck_.outputs() / "final.xyz", state, true);
    for (const DataTable& table : tables) {
        write_file_atomically(deck_.outputs() / (table.name + ".csv"), to_csv(table));
    }
    write_file_atomically(deck_.outputs() / "results.json", few_body_results_json(deck_, result) + "\n");
    write_file_atomically(deck_.outputs() / "results.txt", few_body_results_table(deck_, result));
    record_.finish(result.seconds);
}

}  // namespace ljmd
