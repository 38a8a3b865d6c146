#include "analyze/deck_against_frames.hpp"

#include "catch.hpp"

#include <random>

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// Frames whose total and kinetic energy fluctuate that much, independently.
EnergyFluctuations fluctuations(double total, double kinetic) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    EnergyFluctuations energies;
    for (int k = 0; k < 2000; ++k) {
        Thermodynamics frame;
        frame.total_energy = -5.0 + total * normal(random);
        frame.kinetic_energy = 1.5 + kinetic * normal(random);
        energies.add(frame);
    }
    return energies;
}

std::vector<ObservableAverage> found() {
    return {{"temperature", "T", "epsilon/k_B", Estimate{1.2, 0.01, 100, 1000, true}},
            {"heat_capacity_cv", "c_v", "k_B", Estimate{2.5, 0.1, 100, 1000, true}},
            {"excess_chemical_potential", "mu_ex", "epsilon", Estimate{-3.0, 0.1, 100, 1000, true}}};
}

/// The remark beside an average that was taken back; empty where it was not.
std::string remark(std::size_t k, const DeckClaims& deck, const EnergyFluctuations& energies,
                   std::optional<Index> box_changes = {}) {
    std::vector<ObservableAverage> averages = found();
    withdraw_contradicted(averages, deck, energies, box_changes);
    CHECK(averages[0].estimate.has_value());
    CHECK(averages[k].estimate.has_value() == averages[k].remark.empty());
    return averages[k].remark;
}

}  // namespace

TEST_CASE("the total energy fluctuates against the kinetic one") {
    CHECK(fluctuations(0.3, 0.2).total_over_kinetic().value() == Approx(1.5).epsilon(0.1));
    CHECK(fluctuations(0.0, 0.2).total_over_kinetic().value() == 0.0);
    CHECK_FALSE(fluctuations(0.3, 0.0).total_over_kinetic().has_value());
    CHECK_FALSE(EnergyFluctuations().total_over_kinetic().has_value());
}

TEST_CASE("a heat capacity by the formula of another ensemble than that of the frames is taken back") {
    const EnergyFluctuations constant = fluctuations(1e-4, 0.1);
    const EnergyFluctuations canonical = fluctuations(0.15, 0.1);
    CHECK(remark(1, {Ensemble::constant_energy}, constant).empty());
    CHECK(remark(1, {Ensemble::canonical}, canonical).empty());
    CHECK_THAT(remark(1, {Ensemble::constant_energy}, canonical), Contains("the deck is one of constant energy, but"));
    CHECK_THAT(remark(1, {Ensemble::canonical}, constant), Contains("the deck is one of constant temperature, but"));
    CHECK_THAT(remark(1, {Ensemble::constant_energy}, constant, Index{2}), Contains("the box changes, in frame 2"));
    CHECK_THAT(remark(1, {Ensemble::canonical}, canonical, Index{2}), Contains("not those at constant volume"));
}

TEST_CASE("a chemical potential at another temperature than that of the frames is taken back") {
    const EnergyFluctuations canonical = fluctuations(0.15, 0.1);
    CHECK(remark(2, {Ensemble::canonical, 1.21}, canonical).empty());
    CHECK(remark(2, {Ensemble::canonical, std::nullopt}, canonical).empty());
    CHECK_THAT(remark(2, {Ensemble::canonical, 1.5}, canonical), Contains("holds T = 1.5, but the frames have 1.2"));
}
