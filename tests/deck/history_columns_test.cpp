#include "deck/history_columns.hpp"

#include <algorithm>

#include "deck/deck_fixtures.hpp"
#include "engine/few_body_system.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

TEST_CASE("the history of a fluid has the columns that its stages, its start and its units give a meaning") {
    const auto names = [](const std::string& text, bool order) {
        return thermo_columns(DeckFolder(text).load(), order).names();
    };
    const auto plain = names(small_deck, false);
    for (const char* name : {"density", "conserved_energy", "order_parameter", "time_ps"}) {
        CHECK_FALSE(has(plain, name));
    }
    CHECK(has(names(small_deck, true), "order_parameter"));
    CHECK(has(names(small_deck + argon_table, false), "time_ps"));
    const auto held = [](const std::string& barostat) {
        return small_deck + "thermostat = { type = \"langevin\" }\nbarostat = { type = \"" + barostat +
               "\", pressure = 0.1 }\n";
    };
    CHECK(has(names(held("anisotropic-cell-rescaling"), false), "edge_z"));
    CHECK_FALSE(has(names(held("stochastic-cell-rescaling"), false), "edge_z"));
    CHECK(has(names(held("stochastic-cell-rescaling"), false), "density"));
}

TEST_CASE("trajectories of few bodies have accelerations where the deck asks for them") {
    const DeckFolder folder(stars_deck);
    const auto names = [&](const std::vector<std::string>& settings) {
        const Deck deck = folder.load(settings);
        return trajectory_columns(deck, make_few_body_system(deck.few_bodies())).names();
    };
    CHECK(has(names({}), "vy2"));
    CHECK_FALSE(has(names({}), "ax1"));
    CHECK_FALSE(has(names({}), "angle"));
    CHECK(has(names({"output.trajectory.every=5", "output.trajectory.accelerations=true"}), "ay2"));
}
