// NIST's reference calculations for the Lennard-Jones fluid: energy, virial and tail of four configurations, to the
// printed digits. Source: NIST Standard Reference Simulation Website, doi:10.18434/T4M88Q.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>
#include "catch.hpp"

#include "io/formats/configuration_reader.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

struct Published {
    int config;
    double cutoff, energy, virial, tail;
    std::string energy_lfs, virial_lfs;  // linear force shift, only at rc = 3
};

std::vector<Published> published_values() {
    std::ifstream file(LJMD_TEST_DATA "/nist/published.csv");
    std::vector<Published> rows;
    std::string line;
    while (std::getline(file, line)) {
        if (line.empty() || line[0] == '#' || line[0] == 'c') {
            continue;
        }
        std::vector<std::string> fields;
        std::stringstream stream(line);
        for (std::string field; std::getline(stream, field, ',');) {
            fields.push_back(field);
        }
        fields.resize(9);
        rows.push_back({std::stoi(fields[0]), std::stod(fields[3]), std::stod(fields[4]), std::stod(fields[5]),
                        std::stod(fields[6]), fields[7], fields[8]});
    }
    return rows;
}

/// Equal when rounded to the five significant digits that are printed.
void check_printed(double computed, double printed) {
    const double last_digit = std::pow(10.0, std::floor(std::log10(std::abs(printed))) - 4.0);
    CAPTURE(computed, printed);
    CHECK(std::abs(computed - printed) <= 0.5001 * last_digit);
}

State load(int config) {
    const auto configuration = read_configuration(
        std::string(LJMD_TEST_DATA "/nist/lj_sample_config_periodic") + std::to_string(config) + ".txt", std::nullopt);
    const Box box(configuration.edges);
    State state(static_cast<Index>(configuration.positions.size()), box, test::test_execution());
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3& given = configuration.positions[static_cast<std::size_t>(i)];
        r.col(i) = box.snap(given - box.crossings(given).cwiseProduct(box.edges()));
    }
    return state;
}

}  // namespace

TEST_CASE("NIST reference configurations: energy, virial and tail to the printed digits") {
    const auto rows = published_values();
    REQUIRE(rows.size() == 8);
    for (const Published& row : rows) {
        for (const std::string search : {"all-pairs", "cells", "verlet-list"}) {
            INFO("configuration " << row.config << ", rc " << row.cutoff << ", " << search);
            State state = load(row.config);
            PairForceField cut(PairPotential::lennard_jones("cut", {row.cutoff, 0.0}), make_pair_search(search, 0.3));
            const auto evaluation = cut.evaluate(state, Request::forces_and_energy);
            check_printed(evaluation.potential_energy, row.energy);
            check_printed(evaluation.virial.trace(), row.virial);
            const double atoms = static_cast<double>(state.count());
            check_printed(atoms * TailCorrection(cut.potential()).energy(atoms / state.box().volume()), row.tail);
            if (!row.energy_lfs.empty()) {
                PairForceField shifted(PairPotential::lennard_jones("force-shifted", {row.cutoff, 0.0}),
                                       make_pair_search(search, 0.3));
                const auto lfs = shifted.evaluate(state, Request::forces_and_energy);
                check_printed(lfs.potential_energy, std::stod(row.energy_lfs));
                check_printed(lfs.virial.trace(), std::stod(row.virial_lfs));
            }
        }
    }
}
