#include "ljmd/detail/options/registry.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

struct Animal {
    std::string name;
    int legs;
};

const std::vector<Animal> zoo = {{"ant", 6}, {"bird", 2}, {"cow", 4}};

}  // namespace

TEST_CASE("a registry lists its names in order") {
    CHECK(plugin_names(zoo) == std::vector<std::string>{"ant", "bird", "cow"});
    CHECK(plugin_names(std::vector<Animal>{}).empty());
}

TEST_CASE("a plug-in is found by its exact name") {
    CHECK(find_plugin(zoo, "ant", "animal").legs == 6);
    CHECK(find_plugin(zoo, "cow", "animal").legs == 4);
    for (const std::string wrong : {"", "Ant", "an", "ants", "ant "}) {
        CHECK_THROWS_AS(find_plugin(zoo, wrong, "animal"), InputError);
    }
}

TEST_CASE("an unknown plug-in is refused with the names there are") {
    CHECK_THROWS_WITH(find_plugin(zoo, "dog", "animal"), "unknown animal 'dog', allowed: ant, bird, cow");
    CHECK_THROWS_WITH(find_plugin(std::vector<Animal>{}, "dog", "animal"), "unknown animal 'dog', allowed: ");
}
