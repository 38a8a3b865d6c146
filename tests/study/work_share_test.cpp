#include "study/work_share.hpp"

#include <set>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("the shares of all workers are all entries, each once") {
    for (const std::size_t parts : std::vector<std::size_t>{1, 2, 3, 7, 12}) {
        std::multiset<std::size_t> found;
        for (std::size_t part = 1; part <= parts; ++part) {
            const WorkShare share = work_share(std::to_string(part) + "/" + std::to_string(parts));
            for (std::size_t k = 0; k < 10; ++k) {
                if (share.has(k)) {
                    CHECK(k % parts == part - 1);
                    found.insert(k);
                }
            }
        }
        CHECK(found == std::multiset<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    }
}

TEST_CASE("what is no share is refused") {
    for (const char* text : {"", "1", "/", "1/", "/2", "0/2", "3/2", "-1/2", "+1/2", " 1/2", "1/2/3", "1/2 ", "1.0/2",
                             "a/b", "1/10001", "99999999999999999999/99999999999999999999"}) {
        CHECK_THROWS_AS(work_share(text), InputError);
    }
    CHECK(work_share("10000/10000").part == 10000);
}
