#include "io/tables/thermo_csv.hpp"

#include "io/tables/data_table_csv.hpp"

namespace ljmd {

ThermoCsv::ThermoCsv(const OutputPlace& place, const ThermoColumns& columns, std::optional<std::int64_t> kept)
    : file_(place, kept), columns_(columns) {
    if (!kept) {
        file_.write(csv_header(columns_.names()));
    }
}

void ThermoCsv::write(Index step, double time, const Thermodynamics& sample, const ThermoColumns::Values& values) {
    file_.write(csv_row(columns_.row(step, time, sample, values)));
}

}  // namespace ljmd
