#include "observables/few_body/sign_changes.hpp"

#include <vector>
#include "catch.hpp"

using ljmd::SignChanges;

namespace {

std::vector<SignChanges::Place> places_of(const std::vector<int>& signs) {
    SignChanges changes;
    std::vector<SignChanges::Place> places;
    for (const int sign : signs) {
        places.push_back(changes.next(sign));
    }
    return places;
}

constexpr auto none = SignChanges::Place::nowhere;
constexpr auto last = SignChanges::Place::at_last_sample;
constexpr auto within = SignChanges::Place::within_step;
using Places = std::vector<SignChanges::Place>;

}  // namespace

TEST_CASE("Changes of sign are told within the step, or at the sample that is zero") {
    CHECK(places_of({1, 1, -1, -1, 1}) == Places{none, none, within, none, within});
    CHECK(places_of({1, 0, -1, 1}) == Places{none, none, last, within});
    CHECK(places_of({-1, 0, 0, 1}) == Places{none, none, none, last});
}

TEST_CASE("A zero that is only touched is no change") {
    CHECK(places_of({1, 0, 1, 0, 0, 1}) == Places{none, none, none, none, none, none});
}

TEST_CASE("A series that begins with a zero changes sign there, one of zeros does not") {
    CHECK(places_of({0, 1, 1, -1}) == Places{none, last, none, within});
    CHECK(places_of({0, 0, -1, -1}) == Places{none, none, last, none});
    CHECK(places_of({0, 0, 0}) == Places{none, none, none});
}
