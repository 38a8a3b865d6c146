#include "io/files/output_file.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("an output file holds what was written, in order") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    std::string expected;
    OutputFile file(path);
    for (int i = 0; i < 20000; ++i) {  // several buffers
        const std::string line = "line " + std::to_string(i) + "\n";
        file.write(line);
        expected += line;
    }
    file.close();
    file.close();
    CHECK(content_of(path) == expected);
}

TEST_CASE("flushed text is in the file at once, and a destroyed file is complete") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    {
        OutputFile file(path);
        file.write("first\n");
        CHECK(content_of(path).empty());
        file.flush();
        CHECK(content_of(path) == "first\n");
        file.write("second\n");
        file.sync();
        CHECK(content_of(path) == "first\nsecond\n");
        OutputFile moved(std::move(file));
        moved.write("third\n");
    }
    CHECK(content_of(path) == "first\nsecond\nthird\n");
}

TEST_CASE("an existing file is replaced") {
    const TemporaryFolder folder;
    OutputFile(folder / "a.txt").write("something long\n");
    OutputFile(folder / "a.txt").write("short\n");
    CHECK(content_of(folder / "a.txt") == "short\n");
}

TEST_CASE("no link is written through") {
    const TemporaryFolder folder;
    std::ofstream(folder / "precious") << "mine";
    std::filesystem::create_symlink(folder / "precious", folder / "a.txt");
    CHECK_THROWS_AS(OutputFile(folder / "a.txt"), FileError);
    CHECK(content_of(folder / "precious") == "mine");
}

TEST_CASE("a file that cannot be created is an error that names it and the cause") {
    const TemporaryFolder folder;
    const auto missing = folder / "no/a.txt";
    CHECK_THROWS_AS(OutputFile(missing), FileError);
    CHECK_THROWS_WITH(OutputFile(missing), "cannot create '" + missing.string() + "': No such file or directory");
    CHECK_THROWS_WITH(OutputFile(folder / ""), Contains("Is a directory"));
}

TEST_CASE("a device that takes nothing fails at flush and at close, by name") {
    OutputFile file(std::filesystem::path("/dev/full"));
    file.write("text");
    CHECK_THROWS_WITH(file.flush(), "cannot write '/dev/full': No space left on device");
    CHECK_THROWS_AS(file.write("more"), FileError);
    CHECK_THROWS_AS(file.close(), FileError);

    OutputFile late(std::filesystem::path("/dev/full"));
    late.write("text");
    CHECK_THROWS_WITH(late.close(), "cannot write '/dev/full': No space left on device");
    CHECK_NOTHROW(late.close());
}

TEST_CASE("a failed write cuts the file back to its last flush") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    OutputFile file(path);
    file.write("complete\n");
    file.flush();
    {
        const FileSizeLimit limit(100000);
        const auto overflow = [&file] {
            for (int i = 0; i < 1000; ++i) {
                file.write(std::string(1000, 'x') + "\n");
            }
        };
        CHECK_THROWS_WITH(overflow(), Contains("File too large") && Contains(path.string()));
        CHECK_THROWS_WITH(file.flush(), Contains("an earlier write failed"));
    }
    CHECK_THROWS_AS(file.close(), FileError);
    CHECK(content_of(path) == "complete\n");
}

TEST_CASE("writing to a closed file is a mistake of the program") {
    const TemporaryFolder folder;
    OutputFile file(folder / "a.txt");
    file.close();
    CHECK_THROWS_AS(file.write("late"), ContractViolation);
}

TEST_CASE("a file is continued from the bytes that are kept, whatever comes after them") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    std::int64_t kept = 0;
    {
        OutputFile file(path);
        file.write("one\n");
        kept = file.commit();
        CHECK(content_of(path) == "one\n");
        file.write("half a li");
    }
    CHECK(kept == 4);
    OutputFile again(path, kept);
    CHECK(content_of(path) == "one\n");
    again.write("two\n");
    CHECK(again.commit() == 8);
    again.close();
    CHECK(content_of(path) == "one\ntwo\n");
    OutputFile(path, 0).write("from the start\n");
    CHECK(content_of(path) == "from the start\n");
}

TEST_CASE("a file that has lost what should be kept, or that is no file, is not continued and not touched") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    CHECK_THROWS_AS(OutputFile(path, 0), CheckpointError);
    CHECK_THROWS_WITH(OutputFile(path, 0), Contains("a.txt' is not there any more"));
    std::ofstream(folder / "elsewhere") << "mine";
    std::filesystem::create_symlink(folder / "elsewhere", folder / "link");
    CHECK_THROWS_WITH(OutputFile(folder / "link", 0), Contains("link' is not the file that the run wrote"));
    CHECK(std::filesystem::file_size(folder / "elsewhere") == 4);
    CHECK_FALSE(std::filesystem::exists(path));
    std::ofstream(path) << "short";
    CHECK_THROWS_AS(OutputFile(path, 6), CheckpointError);
    CHECK_THROWS_WITH(OutputFile(path, 6), Contains("has 5 bytes, but had 6 when the checkpoint was written"));
    CHECK(content_of(path) == "short");
    std::filesystem::create_directory(folder / "d");
    CHECK_THROWS_AS(OutputFile(folder / "d", 0), CheckpointError);
}
