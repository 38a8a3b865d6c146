#include "io/tables/few_body_csv.hpp"

#include "io/tables/data_table_csv.hpp"

namespace ljmd {

FewBodyThermoCsv::FewBodyThermoCsv(const OutputPlace& place, int dimensions, std::optional<std::int64_t> kept)
    : file_(place, kept), columns_(dimensions) {
    if (!kept) {
        file_.write(csv_header(columns_.names()));
    }
}

void FewBodyThermoCsv::write(Index step, double time, const FewBodyTotals& totals) {
    file_.write(csv_row(columns_.row(step, time, totals)));
}

TrajectoryCsv::TrajectoryCsv(const OutputPlace& place, const TrajectoryColumns& columns,
                             std::optional<std::int64_t> kept)
    : file_(place, kept), columns_(columns) {
    if (!kept) {
        file_.write(csv_header(columns_.names()));
    }
}

void TrajectoryCsv::write(const State& state, std::optional<double> angle) {
    file_.write(csv_row(columns_.row(state, angle)));
}

}  // namespace ljmd
