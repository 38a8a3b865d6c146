#include "ljmd/app/commands.hpp"
#include "ljmd/app/streams.hpp"
#include "ljmd/app/thermo_report.hpp"

namespace ljmd {

void analyze_command(const std::string& directory, bool json) {
    const ThermoReport report = thermo_report(recorded_run(directory));
    print_result(json ? thermo_json(report) : thermo_table(report));
}

}  // namespace ljmd
