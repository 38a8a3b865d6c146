#include "ljmd/detail/options/table_description.hpp"

#include <memory>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "options/placed.hpp"
#include "options/toml_writer.hpp"

using namespace ljmd;

namespace {

struct ToolOptions {
    Index every = 3;
    virtual ~ToolOptions() = default;
    virtual void describe(Description& description) { description.integer("every", every).at_least(1).step_interval(); }
};

struct Tool {
    std::string name;
    std::string meaning;
    [[nodiscard]] std::unique_ptr<ToolOptions> options() const { return std::make_unique<ToolOptions>(); }
};

std::vector<Tool> all_tools() {
    return {{"hammer", "hits"}, {"saw", "cuts"}};
}

struct Inner {
    double size = 0.5;
    std::optional<std::string> label;
    Choice tool = choice_of(choose(all_tools().front()));

    void describe(TableDescription& description) {
        description.number("size", size).above(0.0);
        description.text("label", label);
        description.plugin("tool", all_tools(), tool);
    }
};

struct Corner {
    double x = 0.0;
    double y = 0.0;

    void describe(Description& description) {
        description.number("x", x);
        description.number("y", y);
    }
};

struct Outer {
    std::string shape;
    double radius = 0.0;
    double edge = 0.0;
    Interval pause = {.seconds = 120.0};
    Placed<Inner> usual;
    std::optional<Placed<Inner>> extra;
    std::vector<Placed<Inner>> parts;
    std::vector<Choice> chosen;
    std::optional<Choice> spare;
    std::vector<double> corner;  ///< x and y, which the table has by their names

    void describe(TableDescription& description) {
        description.required_choice("shape", {"circle", "square"}, shape);
        Description of_circle;
        of_circle.required_number("radius", radius);
        description.when("shape", "circle", of_circle);
        Description of_square;
        of_square.required_number("edge", edge);
        description.when("shape", "square", of_square);
        description.interval("pause", pause);
        description.table("usual", "usual", usual).optional("all defaults");
        description.table("extra", "extra", extra).optional("none");
        description.tables("part", "[[part]]", parts);
        description.choices(all_tools(), "not used", chosen);
        description.plugin_table("spare", all_tools(), spare).optional("none");
        description
            .table_for<Corner>(
                "corner", &corner,
                [this](const Corner& table) {
                    corner = {table.x, table.y};
                },
                [this] {
                    return corner.empty() ? std::nullopt : std::optional(Corner{corner[0], corner[1]});
                })
            .optional("the origin");
    }
};

Location at(int line) {
    static const auto source = std::make_shared<const Source>(Source{"a deck", ""});
    return {source, line, 1, 1};
}

Entry entry_at(const std::string& key, int line, decltype(Value::data) data) {
    return {key, at(line), {std::move(data), at(line)}};
}

/// The table with one part, if it has none.
Placed<Outer> read(Table table, Diagnostics& diagnostics) {
    if (find(table, "part") == nullptr) {
        table.push_back(entry_at("part", 1, Array{{Table{}, at(1)}}));
    }
    return Placed<Outer>(validate(table, at(1), Placed<Outer>::schema("outer"), std::nullopt, diagnostics));
}

Placed<Outer> read(const Table& table) {
    Diagnostics diagnostics;
    const auto outer = read(table, diagnostics);
    diagnostics.throw_if_errors();
    return outer;
}

}  // namespace

TEST_CASE("a table becomes its struct: values, inner tables, arrays of tables and plug-ins") {
    const auto outer = read(
        {entry_at("shape", 2, std::string("circle")), entry_at("radius", 3, 1.5),
         entry_at("extra", 4, Table{entry_at("size", 4, 2.0), entry_at("tool", 4, std::string("saw"))}),
         entry_at("part", 5,
                  Array{{Table{entry_at("label", 5, std::string("first"))}, at(5)},
                        {Table{entry_at("every", 6, std::int64_t{7})}, at(6)}}),
         entry_at("saw", 7, Table{entry_at("every", 7, std::int64_t{9})}), entry_at("pause", 8, std::int64_t{50})});
    CHECK(outer.shape == "circle");
    CHECK(outer.radius == 1.5);
    CHECK(outer.pause.steps == 50);
    CHECK_FALSE(outer.pause.seconds.has_value());
    CHECK(outer.usual.size == 0.5);
    REQUIRE(outer.extra.has_value());
    CHECK(outer.extra->size == 2.0);
    CHECK(outer.extra->tool.name == "saw");
    REQUIRE(outer.parts.size() == 2);
    CHECK(outer.parts[0].label == "first");
    CHECK(outer.parts[0].tool.name == "hammer");
    CHECK(outer.parts[1].tool == Choice{"hammer", {{"every", 7}}});
    CHECK(outer.chosen == std::vector<Choice>{{"saw", {{"every", 9}}}});
    CHECK_FALSE(outer.spare.has_value());
    CHECK(outer.corner.empty());
}

TEST_CASE("a plug-in in a table of its own, and a table whose members have another form") {
    const auto outer = read(
        {entry_at("shape", 2, std::string("circle")), entry_at("radius", 3, 1.5),
         entry_at("spare", 4, Table{entry_at("type", 5, std::string("saw")), entry_at("every", 6, std::int64_t{4})}),
         entry_at("corner", 7, Table{entry_at("y", 8, -2.0)})});
    CHECK(outer.spare == Choice{"saw", {{"every", 4}}});
    CHECK(outer.location_of_type(&Outer::spare).line == 5);
    CHECK(outer.corner == std::vector<double>{0.0, -2.0});
    CHECK(outer.inner(&Outer::corner).all_sound());
    Diagnostics diagnostics;
    const auto unknown = read({entry_at("shape", 2, std::string("circle")), entry_at("radius", 3, 1.5),
                               entry_at("spare", 4, Table{entry_at("type", 5, std::string("axe"))})},
                              diagnostics);
    CHECK(diagnostics.has_errors());
    CHECK_FALSE(unknown.spare.has_value());
}

TEST_CASE("what members make is read to the same members") {
    const auto outer = read(
        {entry_at("shape", 2, std::string("square")), entry_at("edge", 3, 0.1),
         entry_at("pause", 8, std::string("90 s")),
         entry_at("extra", 4, Table{entry_at("size", 4, 2.0), entry_at("tool", 4, std::string("saw"))}),
         entry_at("part", 5,
                  Array{{Table{entry_at("label", 5, std::string("first"))}, at(5)},
                        {Table{entry_at("every", 6, std::int64_t{7})}, at(6)}}),
         entry_at("saw", 7, Table{entry_at("every", 7, std::int64_t{9})}),
         entry_at("spare", 4, Table{entry_at("type", 5, std::string("saw")), entry_at("every", 6, std::int64_t{4})}),
         entry_at("corner", 7, Table{entry_at("y", 8, -2.0)})});
    const Table written = table_of(static_cast<const Outer&>(outer));
    CHECK(
        toml_value({written, {}}) ==
        "{ shape = \"square\", pause = \"90 s\", usual = { size = 0.5, tool = \"hammer\", every = 3 }, extra = { "
        "size = 2.0, tool = \"saw\", every = 3 }, part = [{ size = 0.5, label = \"first\", tool = \"hammer\", every = "
        "3 "
        "}, { size = 0.5, tool = \"hammer\", every = 7 }], saw = { every = 9 }, spare = { type = \"saw\", every = 4 }, "
        "corner = { x = 0.0, y = -2.0 }, edge = 0.1 }");
    CHECK(toml_value({table_of(static_cast<const Outer&>(read(written))), {}}) == toml_value({written, {}}));
}

TEST_CASE("what a table leaves out has the default of its member") {
    const auto outer = read({entry_at("shape", 2, std::string("square")), entry_at("edge", 3, 4.0)});
    CHECK(outer.edge == 4.0);
    CHECK(outer.radius == 0.0);
    CHECK(outer.pause.seconds == 120.0);
    CHECK(outer.usual.size == 0.5);
    CHECK(outer.usual.tool == Choice{"hammer", {{"every", 3}}});
    CHECK_FALSE(outer.usual.label.has_value());
    CHECK_FALSE(outer.extra.has_value());
    CHECK(outer.parts.size() == 1);
    CHECK(outer.chosen.empty());
}

TEST_CASE("places are asked by member") {
    const auto outer = read({entry_at("shape", 2, std::string("circle")), entry_at("radius", 3, 1.5),
                             entry_at("extra", 4, Table{entry_at("every", 5, std::int64_t{2})})});
    CHECK(outer.key(&Outer::radius) == "radius");
    CHECK(outer.key(&Outer::parts) == "part");
    CHECK(outer.location(&Outer::radius).line == 3);
    CHECK(outer.location(&Outer::pause).line == 1);
    CHECK(outer.written(&Outer::radius));
    CHECK(outer.has(&Outer::pause));
    CHECK_FALSE(outer.written(&Outer::pause));
    CHECK_FALSE(outer.has(&Outer::edge));
    CHECK(outer.absent(&Outer::edge));
    REQUIRE(outer.extra.has_value());
    CHECK(outer.extra->location().line == 4);
    CHECK(outer.extra->heading() == "extra");
    CHECK(outer.extra->section().location("every").line == 5);
    REQUIRE(outer.extra->section().step_interval().has_value());
    CHECK(outer.extra->section().step_interval()->every == 2);
    CHECK(outer.extra->section().step_interval()->location.line == 5);
    const Placed<Outer> copy = outer;
    CHECK(copy.location(&Outer::radius).line == 3);
}

TEST_CASE("values that are wrong have stand-ins that are known as such") {
    Diagnostics diagnostics;
    const auto outer =
        read({entry_at("shape", 2, std::string("cirle")), entry_at("usual", 3, Table{entry_at("size", 3, -1.0)})},
             diagnostics);
    CHECK(diagnostics.entries().size() == 2);
    CHECK(outer.shape == "circle");
    CHECK_FALSE(outer.sound(&Outer::shape));
    CHECK_FALSE(outer.given(&Outer::shape));
    CHECK_FALSE(outer.has(&Outer::radius));
    CHECK(outer.usual.size > 0.0);
    CHECK_FALSE(outer.usual.sound(&Inner::size));
    CHECK_FALSE(outer.usual.section().all_sound());
}

TEST_CASE("a member that no key is bound to has no place") {
    struct Forgetful {
        double known = 1.0;
        double forgotten = 1.0;
        void describe(Description& description) { description.number("known", known); }
    };
    CHECK(Placed<Forgetful>::key(&Forgetful::known) == "known");
    CHECK_THROWS_AS(Placed<Forgetful>::key(&Forgetful::forgotten), ContractViolation);
}
