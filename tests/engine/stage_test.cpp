#include "ljmd/engine/stage.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Of the first stage of a liquid with these lines in place of its thermostat.
bool conserves_with(const std::string& lines) {
    const Deck deck =
        DeckFolder(changed(small_deck, {{"thermostat = { type = \"rescale\", every = 5 }", lines}})).load();
    return conserves_energy(deck.stages().front());
}

}  // namespace

TEST_CASE("energy is conserved without a thermostat, and but for its heat under a canonical one at constant volume") {
    const std::string canonical = "thermostat = { type = \"stochastic-rescaling\" }";
    CHECK(conserves_with(""));
    CHECK(conserves_with(canonical));
    CHECK_FALSE(conserves_with("thermostat = { type = \"rescale\", every = 5 }"));
    CHECK_FALSE(
        conserves_with(canonical + "\nbarostat = { type = \"stochastic-cell-rescaling\", pressure = 1.0, every = 5 }"));
}

TEST_CASE("the steps of stages add up, and those before a stage are those of the stages before it") {
    const std::vector<Stage> stages{{.name = "a", .steps = 3}, {.name = "b", .steps = 0}, {.name = "c", .steps = 5}};
    CHECK(steps_before(stages, 0) == 0);
    CHECK(steps_before(stages, 2) == 3);
    CHECK(total_steps(stages) == 8);
    CHECK(total_steps({}) == 0);
}

TEST_CASE("the first sampled stage stands for a run, the last one if none is sampled") {
    std::vector<Stage> stages{{.name = "a"}, {.name = "b"}, {.name = "c"}};
    CHECK(first_sampled(stages) == 2);
    stages[2].sample = true;
    stages[1].sample = true;
    CHECK(first_sampled(stages) == 1);
}
