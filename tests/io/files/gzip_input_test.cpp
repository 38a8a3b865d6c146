#include "io/files/gzip_input.hpp"

#include "catch.hpp"

#include <iterator>
#include <random>
#include <sstream>

#include "io/gzipped.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::gzipped;

namespace {

/// What is unpacked, and why that ended early.
struct Unpacked {
    std::string text;
    std::string fault;
    bool is_cut;
};

Unpacked unpack(const std::string& packed, Index limit = 1'000'000'000) {
    std::istringstream file(packed);
    GzipInput input(file, limit);
    std::string text(std::istreambuf_iterator<char>(&input), {});
    return {std::move(text), input.fault(), input.is_cut()};
}

/// Longer than the blocks in which is read and written, and not to be compressed well.
std::string long_text() {
    std::mt19937 random(7);
    std::string text;
    for (int k = 0; k < 60'000; ++k) {
        text += std::to_string(random()) + '\n';
    }
    return text;
}

}  // namespace

TEST_CASE("what gzip has compressed is unpacked, whatever its length, all members of the file") {
    for (const std::string& text : {std::string(), std::string("a"), long_text(), std::string(1'000'000, 'x')}) {
        const Unpacked found = unpack(gzipped(text));
        CHECK(found.text == text);
        CHECK(found.fault.empty());
    }
    const std::string two = gzipped("one\n") + gzipped("") + gzipped("two\n");
    CHECK(unpack(two).text == "one\ntwo\n");
    CHECK(unpack(two).fault.empty());
    CHECK(is_gzip(two));
    CHECK_FALSE(is_gzip("\x1f"));
}

TEST_CASE("unpacking starts again after rewind") {
    const std::string packed = gzipped("some text");
    std::istringstream file(packed);
    GzipInput input(file, 100);
    for (int k = 0; k < 2; ++k) {
        CHECK(std::string(std::istreambuf_iterator<char>(&input), {}) == "some text");
        input.rewind();
    }
}

TEST_CASE("a compressed file that is cut off anywhere says so, and gives what it has") {
    const std::string packed = gzipped("some text that is compressed");
    for (std::size_t length = 2; length < packed.size(); ++length) {
        CAPTURE(length);
        const Unpacked found = unpack(packed.substr(0, length));
        CHECK(found.is_cut);
        CHECK_THAT(found.fault, Contains("cut off"));
    }
}

TEST_CASE("a bit that turns in a compressed text is seen") {
    const std::string text = "some text that is compressed, some of it twice";
    const std::string packed = gzipped(text);
    for (std::size_t byte = 10; byte < packed.size(); ++byte) {  // the header before it has a time and a name
        CAPTURE(byte);
        std::string damaged = packed;
        damaged[byte] = static_cast<char>(damaged[byte] ^ 4);
        const Unpacked found = unpack(damaged);
        CHECK_FALSE(found.fault.empty());
    }
    CHECK_THAT(unpack(packed + "rubbish").fault, Contains("damaged"));
}

TEST_CASE("no more is unpacked than allowed, however small the file") {
    const std::string bomb = gzipped(std::string(50'000'000, 'x'));
    CHECK(bomb.size() < 60'000);
    const Unpacked found = unpack(bomb, 1'000'000);
    CHECK(found.text.size() <= 1'000'000);
    CHECK_THAT(found.fault, Contains("unpacks to more than 1000000 bytes"));
    CHECK_FALSE(found.is_cut);
    CHECK(unpack(gzipped("12345"), 5).fault.empty());
    CHECK_FALSE(unpack(gzipped("123456"), 5).fault.empty());
}
