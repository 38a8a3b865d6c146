#include "reference/verlet1967.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("the table has 39 rows of falling density, none twice") {
    const auto& table = verlet1967_table();
    REQUIRE(table.size() == 39);
    for (std::size_t k = 1; k < table.size(); ++k) {
        CHECK(table[k].density <= table[k - 1].density);
        for (std::size_t other = 0; other < k; ++other) {
            CHECK((table[k].density != table[other].density || table[k].temperature != table[other].temperature));
        }
    }
}

TEST_CASE("numbers that are called sound lie near the equation of state, those that are suspect do not") {
    const EquationOfState thol = equation_of_state("thol2016");
    for (const VerletRow& row : verlet1967_table()) {
        INFO("density " << row.density << ", temperature " << row.temperature);
        const FluidProperties state = properties(thol, row.temperature, row.density);
        const auto check = [](const std::optional<Printed>& printed, double expected) {
            if (printed && printed->soundness == Soundness::sound) {
                CHECK(std::abs(printed->value - expected) < 0.06);
            } else if (printed && printed->soundness == Soundness::suspect) {
                CHECK(std::abs(printed->value - expected) > 0.06);
            }
        };
        check(row.compressibility_factor, state.compressibility_factor);
        check(row.potential_energy, state.potential_energy);
    }
}

TEST_CASE("what is suspect or metastable is remarked upon") {
    for (const VerletRow& row : verlet1967_table()) {
        for (const auto& printed : {row.compressibility_factor, row.potential_energy}) {
            CHECK((!printed || printed->soundness == Soundness::sound || !row.remark.empty()));
        }
    }
}
