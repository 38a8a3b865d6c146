#include "deck/deck_schema.hpp"

#include "deck/tables/few_body_tables.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "input/deck_reference.hpp"
#include "input/json_schema.hpp"

namespace ljmd {

const Schema& deck_schema(DeckKind kind) {
    static const Schema few_bodies = Placed<FewBodyTables>::schema("the deck");
    static const Schema fluid = Placed<FluidTables>::schema("the deck");
    return kind == DeckKind::few_body ? few_bodies : fluid;
}

std::vector<std::string> marks_of_few_bodies() {
    return {Placed<FewBodyTables>::key(&FewBodyTables::force), Placed<FewBodyTables>::key(&FewBodyTables::bodies)};
}

std::string deck_reference_page() {
    return "# All keys of a deck\n\n"
           "Made by `ljmd info --keys` from the tables that validate decks. A key without a default must be "
           "given.\n\n`ljmd info --schema` prints the same as a JSON Schema, with which editors complete and check "
           "decks. Taplo, "
           "which VS Code's Even Better TOML uses, takes it from a first line `#:schema ljmd.schema.json` where `ljmd "
           "info "
           "--schema > ljmd.schema.json` has put it.\n\n## A fluid\n\n" +
           schema_markdown(deck_schema(DeckKind::fluid), 3) +
           "\n## A few bodies\n\nA deck with `[force]` and `[[body]]` tables: no box, no temperature, and whatever "
           "units its numbers are consistent in.\n\n" +
           schema_markdown(deck_schema(DeckKind::few_body), 3);
}

std::string deck_json_schema() {
    return json_schema("a deck of ljmd",
                       {marks_of_few_bodies(), deck_schema(DeckKind::few_body), deck_schema(DeckKind::fluid)});
}

}  // namespace ljmd
