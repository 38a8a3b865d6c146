#include "ljmd/detail/engine/few_body_spec.hpp"

#include "catch.hpp"

#include "options/placed.hpp"

using namespace ljmd;

TEST_CASE("a body is described by its mass, and by vectors of up to three components") {
    CHECK(Placed<BodyStart>::key(&BodyStart::mass) == "mass");
    const Table table = table_of(BodyStart{2.0, {1.0, -1.0}, {0.5, 0.0}});
    Diagnostics diagnostics;
    const Placed<BodyStart> body(validate(table, {}, Placed<BodyStart>::schema("[[body]]"), std::nullopt, diagnostics));
    CHECK_FALSE(diagnostics.has_errors());
    CHECK(body.mass == 2.0);
    CHECK(body.position == std::vector<double>{1.0, -1.0});
    CHECK(body.velocity == std::vector<double>{0.5, 0.0});
    static_cast<void>(validate(table_of(BodyStart{0.0, {1e101}, {0.0, 0.0, 0.0, 0.0}}), {},
                               Placed<BodyStart>::schema("[[body]]"), std::nullopt, diagnostics));
    CHECK(diagnostics.entries().size() == 3);
}
