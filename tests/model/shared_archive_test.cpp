#include "model/shared_archive.hpp"

#include <mutex>
#include <numeric>
#include "catch.hpp"

#include "execution/rank_team.hpp"

using namespace ljmd;
using test::RankTeam;

namespace {

constexpr Index total = 40'000;  // more than one piece

/// Two numbers for each of the atoms of a rank.
std::vector<int> numbers_of(const Share& share) {
    std::vector<int> numbers(static_cast<std::size_t>(2 * share.count()));
    std::iota(numbers.begin(), numbers.end(), static_cast<int>(2 * share.first));
    return numbers;
}

const std::vector<int> all_numbers = numbers_of({0, total});

/// Run work in each rank of teams of one to three ranks. Each gets the bytes of all numbers as one list.
/// @param work  takes bytes, ranks, and a mutex that a rank holds while it checks
template <class Work>
void share_all_numbers(const Work& work) {
    std::vector<int> numbers = all_numbers;
    Archive one;
    one(numbers);
    const int size = GENERATE(1, 2, 3);
    std::mutex mutex;
    RankTeam(size).run([&](const std::shared_ptr<Ranks>& ranks) { work(one.bytes(), *ranks, mutex); });
}

}  // namespace

TEST_CASE("ranks write the bytes of one list, in their order, whoever has how many") {
    share_all_numbers([](std::span<const std::byte> expected, Ranks& ranks, std::mutex& mutex) {
        // Rank 0 has none, the last one what is left: 30,000 atoms and more.
        const int rank = ranks.rank();
        const bool is_last = rank == ranks.size() - 1;
        const Index first = rank == 0 ? 0 : 1001 * (rank - 1);
        const Share share{first, is_last ? total : 1001 * rank};
        const std::vector<int> here = numbers_of(share);
        Archive a;
        SharedArchive(a, ranks, share.count(), total).write(std::span<const int>(here), 2);
        const std::lock_guard lock(mutex);
        CHECK(a.bytes().size() == (ranks.is_root() ? expected.size() : 0));
        CHECK(std::equal(a.bytes().begin(), a.bytes().end(), expected.begin()));
    });
}

TEST_CASE("each rank reads its share, and looks at all") {
    share_all_numbers([](std::span<const std::byte> written, Ranks& ranks, std::mutex& mutex) {
        Archive a(written);
        std::vector<int> list;
        std::vector<int> seen;
        SharedArchive(a, ranks, 0, total).read(list, 2, [&](std::span<const int> piece) {
            seen.insert(seen.end(), piece.begin(), piece.end());
        });
        a.expect_end();
        const std::lock_guard lock(mutex);
        CHECK(list == numbers_of(even_share(total, ranks)));
        CHECK(seen == all_numbers);
    });
}

TEST_CASE("a list of another length, or longer than its file, is refused") {
    std::vector<int> list;
    const auto read = [&](Index atoms, std::span<const std::byte> bytes) {
        Archive a(bytes);
        SharedArchive(a, no_other_ranks(), 0, atoms).read(list, 2, [](std::span<const int>) {});
    };
    std::vector<int> written(20);
    Archive one;
    one(written);
    CHECK_NOTHROW(read(10, one.bytes()));
    CHECK_THROWS_AS(read(9, one.bytes()), CheckpointError);
    CHECK_THROWS_AS(read(10, one.bytes().first(one.bytes().size() - 1)), CheckpointError);
    Archive claims;
    std::uint64_t many = std::uint64_t{1} << 60;
    claims(many);
    CHECK_THROWS_AS(read(Index{1} << 59, claims.bytes()), CheckpointError);
    CHECK(list.size() <= 20);
}
