#include "study/sweep_points.hpp"

#include <set>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Values = std::vector<std::string>;

TEST_CASE("keys are told by their last parts where that is enough") {
    CHECK(short_keys({"system.temperature", "system.density"}) == Values{"temperature", "density"});
    CHECK(short_keys({"stage.melt.steps", "stage.production.steps", "title"}) ==
          Values{"stage.melt.steps", "stage.production.steps", "title"});
    CHECK(short_keys({"stage.\"a.b\".steps"}) == Values{"steps"});
}

TEST_CASE("so many keys can be varied, and no more") {
    Values keys;
    for (std::size_t k = 0; k <= max_varied_keys; ++k) {
        keys.push_back("k" + std::to_string(k));
    }
    Diagnostics diagnostics;
    check_keys(keys, {}, {}, diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(diagnostics.entries()[0].message == "33 keys, at most 32 are allowed");
    keys.pop_back();
    Diagnostics none;
    check_keys(keys, {}, {}, none);
    CHECK(none.entries().empty());
}

TEST_CASE("the name of a point tells its values and is safe in a shell and a file system") {
    const SweepPoints points{{"system.temperature", "potential.truncation"},
                             {{"1.2", "cut"}, {"86.5 K", "../x"}, {"-1e+20", "\xC3\x85; $(rm)"}}};
    CHECK(point_names(points) == Values{"temperature=1.2,truncation=cut", "temperature=86.5-K,truncation=..-x",
                                        "temperature=-1e+20,truncation=------rm-"});
}

TEST_CASE("no two points have one name, and no directory that of another's log") {
    const SweepPoints points{{"k"}, {{"a b"}, {"a-b"}, {"a/b"}, {"x.log"}, {"x"}, {"y"}, {"y.log"}}};
    CHECK(point_names(points) == Values{"k=a-b", "k=a-b-2", "k=a-b-3", "k=x.log", "k=x-2", "k=y", "k=y.log-2"});
    const SweepPoints large{{"k"}, {{std::string(5000, 'a') + "1"}, {std::string(5000, 'a') + "2"}}};
    const Values names = point_names(large);
    CHECK(std::set<std::string>(names.begin(), names.end()).size() == 2);
    CHECK(names[0].size() <= 210);
    CHECK(names[1].size() <= 210);
}

TEST_CASE("a point is made by the settings of its keys") {
    CHECK(point_settings({{"a.b", "c"}, {{"1", "x"}, {"2", "[1, 2]"}}}, 1) == Values{"a.b=2", "c=[1, 2]"});
}

TEST_CASE("points get seeds that count up, unless there are seeds already") {
    const SweepPoints points{{"system.temperature"}, {{"1.2"}, {"1.3"}}};
    const SweepPoints own = with_seeds(points, 42);
    CHECK(own.keys == Values{"system.temperature", "system.seed"});
    CHECK(own.values == std::vector<Values>{{"1.2", "42"}, {"1.3", "43"}});
    CHECK_THROWS_AS(with_seeds(own, 1), InputError);
    CHECK_NOTHROW(with_seeds(points, (std::uint64_t{1} << 53U) - 3));
    CHECK_THROWS_AS(with_seeds(points, (std::uint64_t{1} << 53U) - 2), InputError);
}

TEST_CASE("names of many points that look alike are found one after the other") {
    SweepPoints alike{{"k"}, {}};
    for (std::size_t point = 0; point < max_points; ++point) {
        alike.values.push_back({std::string(300, 'a') + std::to_string(point)});
    }
    const Values names = point_names(alike);
    CHECK(names.back() == names.front() + "-" + std::to_string(max_points));
}
