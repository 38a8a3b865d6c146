#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/run/interruption.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("resume continues a run that its wall time has stopped, in its directory") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    CHECK_THROWS_AS(command({"run", deck, "--out", out, "--quiet", "--walltime", "soon"}), InputError);
    static_cast<void>(said([&] {
        CHECK_THROWS_AS(command({"run", deck, "--out", out, "--quiet", "--walltime", "1e-6 s"}), Interrupted);
    }));
    const Said words = said([&] { command({"resume", out, "--quiet", "--json"}); });
    CHECK(parse_json(words.out).at("observables").contains("temperature"));
    CHECK(parse_json(content_of(folder / "out" / "run.json")).at("resumed_at_steps") == Data::list({0}));

    static_cast<void>(said([&] { command({"resume", out, "--quiet", "--steps", "+10"}); }));
    CHECK(parse_json(content_of(folder / "out" / "run.json")).at("steps_added") == 10);
    CHECK(parse_json(content_of(folder / "out" / "results.json")).at("stages").at(1).at("steps") == 50);
    CHECK_THROWS_AS(command({"resume", (folder / "nowhere").string()}), DataError);
}
