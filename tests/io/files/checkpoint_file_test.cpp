#include "io/files/checkpoint_file.hpp"

#include <sys/stat.h>

#include <fstream>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// What writes a text as the content of a checkpoint.
std::function<void(Archive&)> content(const std::string& text) {
    return [text](Archive& a) { a.numbers(std::span<const char>(text)); };
}

void overwrite(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// The contents of the whole checkpoints, newest first.
std::vector<std::string> contents(const FoundCheckpoints& found) {
    std::vector<std::string> all;
    for (const CheckpointFile& file : found.whole) {
        std::string text(file.length, '\0');
        Archive a = file.content();
        a.numbers(std::span(text));
        a.expect_end();
        all.push_back(text);
    }
    return all;
}

}  // namespace

TEST_CASE("the newest generations are kept, and found newest first") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    CHECK(find_checkpoints(folder.path()).whole.empty());
    store.write(content("first"));
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"first"});
    store.write(content(""));
    store.write(content("third"));
    const FoundCheckpoints found = find_checkpoints(folder.path());
    CHECK(contents(found) == std::vector<std::string>{"third", ""});
    CHECK(found.damaged.empty());
    CHECK(found.whole[0].generation == 3);

    CheckpointStore later(folder.path(), 2);
    later.continue_after(3);
    later.write(content("fourth"));
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"fourth", "third"});
}

TEST_CASE("checkpoints are told apart by their hashes") {
    const auto hash = [](const std::string& text) {
        const ScratchDirectory folder;
        CheckpointStore(folder.path(), 2).write(content(text));
        return find_checkpoints(folder.path()).whole.at(0).hash;
    };
    CHECK(hash("first").size() == 16);
    CHECK(hash("first") == hash("first"));
    CHECK(hash("first") != hash("firsu"));
}

TEST_CASE("after going on from the older of two generations, that one is not what is replaced") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    store.write(content("first"));
    store.write(content("second"));
    const auto newest = find_checkpoints(folder.path()).whole[0].path;
    overwrite(newest, "damaged");
    CheckpointStore later(folder.path(), 2);
    later.continue_after(1);
    later.write(content("another second"));
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"another second", "first"});
}

TEST_CASE("a checkpoint of which any bit is wrong, or that ends anywhere, is not taken, and the older one is") {
    const ScratchDirectory folder;
    CheckpointStore store(folder.path(), 2);
    store.write(content("older"));
    store.write(content("newer"));
    const auto path = find_checkpoints(folder.path()).whole[0].path;
    const std::string whole = content_of(path);
    const auto check_refused = [&] {
        const FoundCheckpoints found = find_checkpoints(folder.path());
        CHECK(contents(found) == std::vector<std::string>{"older"});
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
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"newer", "older"});
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
    store.write(content("first"));
    store.write(content("second"));
    const auto oldest = find_checkpoints(folder.path()).whole[1].path;
    std::filesystem::remove(oldest);
    std::filesystem::create_directories(oldest / "in the way");
    CHECK_THROWS_AS(store.write(content("third")), FileError);
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"second"});
    std::filesystem::remove_all(oldest);
    store.write(content("third"));
    CHECK(contents(find_checkpoints(folder.path())) == std::vector<std::string>{"third", "second"});
}

TEST_CASE("at least one generation is kept, and at most nine") {
    CHECK_THROWS_AS(CheckpointStore(std::filesystem::path("."), 0), ContractViolation);
    CHECK_THROWS_AS(CheckpointStore(std::filesystem::path("."), 10), ContractViolation);
    CHECK(checkpoint_names().size() == 9);
    CHECK(checkpoint_names().front() == "checkpoint.1");
}
