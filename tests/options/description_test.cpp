#include "ljmd/detail/options/description.hpp"

#include <memory>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/section.hpp"

using namespace ljmd;

namespace {

struct Options {
    bool on = true;
    Index count = 3;
    std::optional<Index> most;
    double time = 0.5;
    std::optional<double> limit;
    std::string start = "taylor";
    Index body = 0;
    double pressure = 0.0;

    void describe(Description& d) {
        d.flag("on", on).meaning("whether");
        d.integer("count", count).at_least(1);
        d.integer("most", most).optional("no limit");
        d.number("time", time).unit("tau").above(0.0);
        d.number("limit", limit);
        d.choice("start", {"taylor", "euler"}, start);
        d.required_integer("body", body);
        d.required_number("pressure", pressure);
    }
};

struct Plugin {
    [[nodiscard]] std::unique_ptr<Options> options() const { return std::make_unique<Options>(); }
};

/// Options with the values of a table that has the given entries.
Options taken(const Table& table) {
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema("options", keys_of(Plugin())), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return *choose(Plugin(), section).options;
}

Entry entry(const std::string& key, const decltype(Value::data)& data) {
    return {key, {}, {data, {}}};
}

}  // namespace

TEST_CASE("keys come from the members: defaults are what they hold, and what cannot be missing has none") {
    const std::vector<Key> keys = keys_of(Plugin());
    REQUIRE(keys.size() == 8);
    CHECK(keys[0].name == "on");
    CHECK(keys[0].meaning_text == "whether");
    CHECK(keys[0].default_value == PlainValue(true));
    CHECK(keys[1].default_value == PlainValue(std::int64_t{3}));
    CHECK(keys[1].low == 1.0);
    CHECK_FALSE(keys[2].required);
    CHECK_FALSE(keys[2].default_value.has_value());
    CHECK(keys[2].absent_text == "no limit");
    CHECK(keys[3].default_value == PlainValue(0.5));
    CHECK(keys[3].reduced_unit == "tau");
    CHECK_FALSE(keys[4].required);
    CHECK(keys[5].choices == std::vector<std::string>{"taylor", "euler"});
    CHECK(keys[5].default_value == PlainValue(std::string("taylor")));
    CHECK(keys[6].required);
    CHECK(keys[7].required);
}

TEST_CASE("members take the values of a table, and keep their defaults where it has none") {
    const Options usual = taken({entry("body", std::int64_t{2}), entry("pressure", 1.5)});
    CHECK(usual.on);
    CHECK(usual.count == 3);
    CHECK_FALSE(usual.most.has_value());
    CHECK(usual.time == 0.5);
    CHECK_FALSE(usual.limit.has_value());
    CHECK(usual.start == "taylor");
    CHECK(usual.body == 2);
    CHECK(usual.pressure == 1.5);
    const Options other = taken({entry("on", false), entry("count", std::int64_t{7}), entry("most", std::int64_t{9}),
                                 entry("time", 2.0), entry("limit", 4.0), entry("start", std::string("euler")),
                                 entry("body", std::int64_t{1}), entry("pressure", 0.0)});
    CHECK_FALSE(other.on);
    CHECK(other.count == 7);
    CHECK(other.most == 9);
    CHECK(other.time == 2.0);
    CHECK(other.limit == 4.0);
    CHECK(other.start == "euler");
}

TEST_CASE("texts, vectors, quantities and intervals are bound as numbers are") {
    struct Other {
        std::optional<bool> tail;
        std::string title = "none";
        std::optional<std::string> file;
        std::optional<std::string> velocities;
        std::string name;
        std::string type;
        std::vector<double> position;
        double mass = 0.0;
        double bound = 0.0;
        Interval every = {.seconds = 300.0};
        double unbound = 0.0;
    } other;
    Description d;
    d.flag("tail", other.tail);
    d.text("title", other.title);
    d.text("file", other.file);
    d.choice("velocities", {"maxwell", "file"}, other.velocities);
    d.required_text("name", other.name);
    d.required_choice("type", {"fcc", "random"}, other.type);
    d.required_vector("position", other.position);
    d.required_quantity("mass", Dimension::mass, other.mass);
    d.bind(Key::number("depth").above(0.0), other.bound);
    d.interval("every", other.every);
    const std::vector<Key> keys = d.keys();
    REQUIRE(keys.size() == 10);
    CHECK_FALSE(keys[0].required);
    CHECK(keys[1].default_value == PlainValue(std::string("none")));
    CHECK_FALSE(keys[2].required);
    CHECK(keys[3].choices.size() == 2);
    CHECK_FALSE(keys[3].required);
    for (std::size_t k = 4; k < 9; ++k) {
        CHECK(keys[k].required);
    }
    CHECK(keys[7].physical_dimension == Dimension::mass);
    CHECK(keys[8].low_open);
    CHECK(keys[9].default_value == PlainValue(std::string("5 min")));

    d.take("tail", PlainValue(true));
    d.take("file", PlainValue(std::string("a.xyz")));
    d.take("position", PlainValue(std::vector<double>{1.0, 2.0}));
    d.take("depth", PlainValue(1.5));
    d.take("every", PlainValue(std::int64_t{40}));
    CHECK(other.tail == true);
    CHECK(other.file == "a.xyz");
    CHECK(other.position == std::vector<double>{1.0, 2.0});
    CHECK(other.bound == 1.5);
    CHECK(other.every.steps == 40);
    CHECK_FALSE(other.every.seconds.has_value());
    CHECK(settings_in_words(d.values()) ==
          "tail=true title=none file=a.xyz name= type= position=[1, 2] mass=0 kg depth=1.5 every=40");
    d.take("every", PlainValue(std::string("90 s")));
    CHECK(other.every.seconds == 90.0);

    REQUIRE(d.key_of(&other.bound) != nullptr);
    CHECK(*d.key_of(&other.bound) == "depth");
    CHECK(*d.key_of(&other.tail) == "tail");
    CHECK(d.key_of(&other.unbound) == nullptr);
}

TEST_CASE("the values of the members by their keys, without absent ones") {
    Options options;
    Description description;
    options.describe(description);
    CHECK(settings_in_words(description.values()) == "on=true count=3 time=0.5 start=taylor body=0 pressure=0");
    CHECK(choose(Plugin()).values == description.values());
    options.most = 4;
    CHECK(description.values()[2] == std::pair<std::string, PlainValue>("most", std::int64_t{4}));
    CHECK(description.values().size() == 7);
}

TEST_CASE("a value that no option has is a mistake of the caller") {
    Options options;
    Description description;
    options.describe(description);
    description.take("most", PlainValue(std::int64_t{5}));
    CHECK(options.most == 5);
    CHECK_THROWS_AS(description.take("least", PlainValue(std::int64_t{5})), ContractViolation);
    CHECK_THROWS_AS(description.take("time", PlainValue(std::string("soon"))), ContractViolation);
}
