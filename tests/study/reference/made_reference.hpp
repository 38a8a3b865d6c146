#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/output_fixtures.hpp"
#include "study/reference/reference_values.hpp"

namespace ljmd::test {

/// A request for a liquid of 864 atoms.
inline ReferenceRequest liquid_request() {
    ReferenceRequest request;
    request.temperature = 1.2;
    request.density = 0.75;
    request.properties = {"potential_energy", "pressure", "compressibility_factor"};
    return request;
}

/// What canonical replicas leave, made up: rows behind step 100 of four runs, and merged results.
class MadeUpReplicas {
  public:
    /// @param energies, pressures  means of the runs, around which the rows alternate
    MadeUpReplicas(const std::vector<double>& energies, const std::vector<double>& pressures, double temperature) {
        found_.merged = folder_ / "";
        for (std::size_t k = 0; k < energies.size(); ++k) {
            const std::filesystem::path run = folder_ / fmt::format("replica-{}", k + 1);
            std::filesystem::create_directory(run);
            found_.runs.push_back(run);
            std::ofstream(run / "results.json")
                << R"({"observables": {}, "stages": [{"sampled": false, "first_step": 0, "steps": 100},
                       {"sampled": true, "first_step": 100, "steps": 20000}]})";
            std::ofstream thermo(run / "thermo.csv");
            thermo << "step,temperature,potential_energy,pressure\n0,9,9,9\n100,9,9,9\n";
            for (int row = 1; row <= 2000; ++row) {
                const double swing = row % 2 == 0 ? 0.01 : -0.01;
                thermo << fmt::format("{},{},{},{}\n", 100 + 10 * row, temperature + swing, energies[k] + swing,
                                      pressures[k] - swing);
            }
        }
        std::ofstream rdf(folder_ / "rdf.csv");
        rdf << "r,g\n";
        for (double r = 3.0; r < 6.0; r += 0.02) {
            rdf << fmt::format("{},{}\n", r, 1.0 + 0.01 * std::cos(7.0 * r));
        }
    }

    void merged_results(const std::string& observables) const {
        std::ofstream(folder_ / "results.json") << "{\"observables\": {" + observables + "}, \"doubts\": []}";
    }
    [[nodiscard]] const ReplicaFolder& folder() const { return found_; }

  private:
    TemporaryFolder folder_;
    ReplicaFolder found_;
};

/// An observable in merged results.
inline std::string observable(const std::string& name, double mean, double error, const std::string& unit = "1") {
    return fmt::format(
        R"("{}": {{"mean": {}, "standard_error": {}, "independent_samples": 1000, "samples": 2000,
               "error_is_converged": true, "unit": "{}"}})",
        name, mean, error, unit);
}

/// What cutoff_correction leaves there.
inline std::string cutoff_observables() {
    return observable("cutoff_energy", -0.002, 1e-4) + ", " + observable("cutoff_pressure", -0.005, 5e-4) + ", " +
           observable("cutoff_energy_response", -0.001, 1e-4) + ", " +
           observable("cutoff_pressure_response", -0.004, 5e-4);
}

}  // namespace ljmd::test
