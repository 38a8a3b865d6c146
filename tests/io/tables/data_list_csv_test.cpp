#include "io/tables/data_list_csv.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("objects are rows, their keys columns in the order in which they come first") {
    const Data objects = Data::list({{{"T", 0.5}, {"name", "a,b"}}, {{"T", 1.0}, {"p", nullptr}, {"failure", "none"}}});
    CHECK(data_list_csv(objects) == "T,name,p,failure\n0.5,\"a,b\",,\n1.0,,,none\n");
}

TEST_CASE("objects within are columns with both names, texts in a list one field, other lists left out") {
    const Data objects = Data::list({{{"liquid", Data{{"density", 0.75}}},
                                      {"warnings", Data::list({"one", "two"})},
                                      {"metastable", Data::list({Data{{"x", 1}}})}},
                                     {{"warnings", Data::list()}}});
    CHECK(data_list_csv(objects) == "liquid_density,warnings\n0.75,one; two\n,\n");
}

TEST_CASE("what is no list of objects is refused, and an empty list has no columns") {
    CHECK(data_list_csv(Data::list()) == "\n");
    CHECK_THROWS_AS(data_list_csv(Data::list({Data(1)})), WrongData);
}
