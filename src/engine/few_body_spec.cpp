#include "ljmd/detail/engine/few_body_spec.hpp"

namespace ljmd {

namespace {

constexpr double largest_coordinate = 1e100;  // its square and cube are finite
constexpr double largest_mass = 1e100;

Key& describe_vector(Description& description, const std::string& name, std::vector<double>& components) {
    return description.required_vector(name, components).at_least(-largest_coordinate).at_most(largest_coordinate);
}

}  // namespace

void BodyStart::describe(Description& description) {
    description.required_number("mass", mass).above(0.0).at_most(largest_mass).meaning("mass of the body");
    describe_vector(description, "position", position)
        .meaning(
            "where it starts; one, two or three components, as many for all bodies. An angle or a distance where the "
            "force has such a coordinate");
    describe_vector(description, "velocity", velocity).meaning("its velocity there");
}

}  // namespace ljmd
