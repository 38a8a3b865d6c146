#include "ljmd/detail/core/data.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("members keep the order in which they were added, and each is found by its key") {
    Data data = {{"b", 1}, {"a", {{"inner", true}}}};
    data["c"] = "text";
    data["a"]["more"] = 2;
    data["b"] = 3;
    std::vector<std::string> keys;
    for (const Member& member : data.members()) {
        keys.push_back(member.key);
    }
    CHECK(keys == std::vector<std::string>{"b", "a", "c"});
    CHECK(data.at("b").integer() == 3);
    CHECK(data.at("a").at("inner").flag());
    CHECK(data.at("a").at("more").integer() == 2);
    CHECK(data.contains("c"));
    CHECK_FALSE(data.contains("inner"));
    CHECK(data.find("d") == nullptr);
    CHECK(Data(1).find("d") == nullptr);
}

TEST_CASE("a number that is not finite, and one that is not known, are null") {
    CHECK(Data().is_null());
    CHECK(Data(nullptr).is_null());
    CHECK(Data(std::numeric_limits<double>::quiet_NaN()).is_null());
    CHECK(Data(-std::numeric_limits<double>::infinity()).is_null());
    CHECK(Data(std::optional<double>()).is_null());
    CHECK(Data(std::optional<double>(std::nan(""))).is_null());
    CHECK(Data(std::optional<double>(1.5)).number() == 1.5);
    CHECK(Data(std::optional<std::int64_t>(2)).integer() == 2);
}

TEST_CASE("integers keep all their bits") {
    CHECK(Data(std::numeric_limits<std::int64_t>::min()).integer() == std::numeric_limits<std::int64_t>::min());
    CHECK(Data(std::size_t{7}).integer() == 7);
    const Data large(std::numeric_limits<std::uint64_t>::max());
    CHECK(large.is_integer());
    CHECK(std::get<std::uint64_t>(large.value()) == std::numeric_limits<std::uint64_t>::max());
    CHECK(large.number() == 18446744073709551616.0);
    CHECK_THROWS_WITH(large.integer(), "it is too large an integer");
}

TEST_CASE("lists are made of values, of vectors and item by item") {
    Data list = Data::list({1, "two", {{"three", 3}}});
    list.push_back(nullptr);
    CHECK(list.size() == 4);
    CHECK(list[1].text() == "two");
    CHECK(list.at(2).at("three") == 3);
    CHECK(Data(std::vector<std::string>{"a", "b"}) == Data::list({"a", "b"}));
    Data made;
    made.push_back(Data::list()).push_back(2);
    CHECK(made == Data::list({Data::list({2})}));
}

TEST_CASE("empty lists and objects are what they are, and neither is null") {
    CHECK(Data::list().is_list());
    CHECK(Data::object().is_object());
    CHECK(Data::list().empty());
    CHECK(Data::object().empty());
    CHECK_FALSE(Data::list() == Data::object());
    CHECK_FALSE(Data::list() == Data());
}

TEST_CASE("values are equal whatever the order of members, and integers equal numbers of the same value") {
    CHECK(Data{{"a", 1}, {"b", 2}} == Data{{"b", 2.0}, {"a", 1}});
    CHECK_FALSE(Data{{"a", 1}} == Data{{"a", 1}, {"b", 2}});
    CHECK_FALSE(Data{{"a", 1}} == Data{{"b", 1}});
    CHECK_FALSE(Data(1) == Data(true));
    CHECK_FALSE(Data("1") == Data(1));
    CHECK_FALSE(Data(1.5) == Data(1));
}

TEST_CASE("the members of one object are set in another") {
    Data data = {{"a", 1}, {"b", 2}};
    data.update({{"b", 3}, {"c", 4}});
    CHECK(data == Data{{"a", 1}, {"b", 3}, {"c", 4}});
    CHECK_THROWS_AS(data.update(Data::list()), WrongData);
}

TEST_CASE("a value that is asked for as what it is not says both") {
    CHECK_THROWS_WITH(Data(1).text(), "type must be string, but is number");
    CHECK_THROWS_WITH(Data("x").number(), "type must be number, but is string");
    CHECK_THROWS_WITH(Data(1.0).integer(), "type must be integer, but is number");
    CHECK_THROWS_WITH(Data().flag(), "type must be boolean, but is null");
    CHECK_THROWS_WITH(Data::object().items(), "type must be array, but is object");
    CHECK_THROWS_WITH(Data::list().members(), "type must be object, but is array");
    CHECK_THROWS_WITH(Data::object().at("x"), "key 'x' not found");
    CHECK_THROWS_WITH(Data::list({1}).at(1), "array index 1 is out of range");
    CHECK_THROWS_WITH(Data(true).at("x"), "type must be object, but is boolean");
    CHECK_THROWS_AS(Data(1)["x"], WrongData);
    CHECK_THROWS_AS(Data(1).push_back(2), WrongData);
}

TEST_CASE("an object with two members of one name is a mistake in the program") {
    CHECK_THROWS_AS((Data{{"a", 1}, {"a", 2}}), ContractViolation);
}
