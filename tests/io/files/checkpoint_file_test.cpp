#include "ljmd/io/files/checkpoint_file.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    std::vector<std::byte> bytes(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        bytes[i] = static_cast<std::byte>(text[i]);
    }
    return bytes;
}

void overwrite(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

using Contents = std::vector<std::vector<std::byte>>;

/// The contents of the whole checkpoints, newest first.
Contents contents(const FoundCheckpoints& found) {
    Contents all;
    for (const CheckpointFile& file : found.whole) {
        all.push_back(file.content);
    }
    return all;
}

}  // namespace

TEST_CASE("the newest generations are kept, and found newest first") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    CHECK(find_checkpoints(folder.path()).whole.empty());
    store.write(bytes_of("first"));
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("first")});
    store.write(bytes_of(""));
    store.write(bytes_of("third"));
    const FoundCheckpoints found = find_checkpoints(folder.path());
    CHECK(contents(found) == Contents{bytes_of("third"), bytes_of("")});
    CHECK(found.damaged.empty());
    CHECK(found.whole[0].generation == 3);

    CheckpointStore later(folder.path(), 2);
    later.continue_after(3);
    later.write(bytes_of("fourth"));
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("fourth"), bytes_of("third")});
}

TEST_CASE("after going on from the older of two generations, that one is not what is replaced") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    store.write(bytes_of("first"));
    store.write(bytes_of("second"));
    const auto newest = find_checkpoints(folder.path()).whole[0].path;
    overwrite(newest, "damaged");
    CheckpointStore later(folder.path(), 2);
    later.continue_after(1);
    later.write(bytes_of("another second"));
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("another second"), bytes_of("first")});
}

TEST_CASE("a checkpoint of which any bit is wrong, or that ends anywhere, is not taken, and the older one is") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    store.write(bytes_of("older"));
    store.write(bytes_of("newer"));
    const auto path = find_checkpoints(folder.path()).whole[0].path;
    const std::string whole = content_of(path);
    const auto check_refused = [&] {
        const FoundCheckpoints found = find_checkpoints(folder.path());
        CHECK(contents(found) == Contents{bytes_of("older")});
        REQUIRE(found.damaged.size() == 1);
        CHECK_THAT(found.damaged[0], Contains(path.string() + ": it "));
    };
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        overwrite(path, damaged);
        check_refused();
    }
    for (std::size_t length = 0; length < whole.size(); ++length) {
        overwrite(path, whole.substr(0, length));
        check_refused();
    }
    overwrite(path, whole + "x");
    check_refused();
    overwrite(path, whole);
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("newer"), bytes_of("older")});
}

TEST_CASE("what is no file is told, and nothing waits for it") {
    const ScratchDirectory folder;
    std::filesystem::create_directory(folder.path() / "checkpoint.1");
    REQUIRE(::mkfifo((folder.path() / "checkpoint.2").c_str(), 0600) == 0);
    std::filesystem::create_symlink("nowhere", folder.path() / "checkpoint.3");
    const FoundCheckpoints found = find_checkpoints(folder.path());
    CHECK(found.whole.empty());
    REQUIRE(found.damaged.size() == 3);
    for (const std::string& line : found.damaged) {
        CHECK_THAT(line, Contains("it is not a file"));
    }
}

TEST_CASE("a checkpoint that cannot be written leaves the earlier ones") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    store.write(bytes_of("first"));
    store.write(bytes_of("second"));
    const auto oldest = find_checkpoints(folder.path()).whole[1].path;
    std::filesystem::remove(oldest);
    std::filesystem::create_directories(oldest / "in the way");
    CHECK_THROWS_AS(store.write(bytes_of("third")), FileError);
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("second")});
    std::filesystem::remove_all(oldest);
    store.write(bytes_of("third"));
    CHECK(contents(find_checkpoints(folder.path())) == Contents{bytes_of("third"), bytes_of("second")});
}

TEST_CASE("at least one generation is kept, and at most nine") {
    CHECK_THROWS_AS(CheckpointStore(std::filesystem::path("."), 0), ContractViolation);
    CHECK_THROWS_AS(CheckpointStore(std::filesystem::path("."), 10), ContractViolation);
    CHECK(checkpoint_names().size() == 9);
    CHECK(checkpoint_names().front() == "checkpoint.1");
}
