#include "study/reference/reference_property.hpp"

#include <set>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "observables/statistics/known_quantities.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

TEST_CASE("every property has one name, one alias, and a unit unless it is a table") {
    std::set<std::string> names;
    for (const ReferenceProperty& property : reference_properties()) {
        INFO(property.name);
        CHECK(names.insert(property.name).second);
        CHECK(names.insert(property.alias).second);
        CHECK(&reference_property(property.name) == &property);
        CHECK(&reference_property(property.alias) == &property);
        CHECK((find_quantity(property.name) != nullptr) == (property.measured != MeasuredBy::structure));
    }
    CHECK_THROWS_WITH(reference_property("entropy"),
                      Contains("unknown property 'entropy'") && Contains("heat_capacity_cv (c_v)"));
}

TEST_CASE("an equation of state has all but tables and transport") {
    const FluidProperties state = properties(equation_of_state("thol2016"), 1.2, 0.75);
    for (const ReferenceProperty& property : reference_properties()) {
        INFO(property.name);
        const bool has = property.measured != MeasuredBy::structure && property.measured != MeasuredBy::transport;
        CHECK(value_by_equation(property, state).has_value() == has);
    }
    CHECK(value_by_equation(reference_property("w"), state) == state.speed_of_sound());
    CHECK(value_by_equation(reference_property("mu_JT"), state) == state.joule_thomson_coefficient());
    CHECK(value_by_equation(reference_property("kappa_T"), state) == state.isothermal_compressibility());
    CHECK(value_by_equation(reference_property("alpha_p"), state) == state.thermal_expansion());
    CHECK(value_by_equation(reference_property("mu_ex"), state) == state.excess_chemical_potential);
}
