#include "run/earlier_run.hpp"

#include <map>

#include "io/files/directory_lock.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> names{"checkpoint.1", "failed.xyz", "run.json", "thermo.csv"};

/// Files below a folder: path and text.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            found[fs::relative(entry.path(), folder).string()] = content_of(entry.path());
        }
    }
    return found;
}

class RunFolder {
  public:
    RunFolder() {
        write("run.json", "old");
        write("thermo.csv", "old");
        write("checkpoint.1", "old");
        write("notes.txt", "mine");
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    [[nodiscard]] std::map<std::string, std::string> files() const { return contents(folder_ / ""); }
    [[nodiscard]] OpenDirectory directory() const { return {folder_ / ""}; }
    [[nodiscard]] fs::path operator/(const std::string& name) const { return folder_ / name; }

  private:
    TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("an earlier run is out of the way of a new one, and gone when that has begun") {
    const RunFolder folder;
    EarlierRun earlier(folder.directory(), names);
    CHECK_FALSE(fs::exists(folder / "run.json"));
    CHECK(content_of(folder / "notes.txt") == "mine");
    folder.write("run.json", "new");
    folder.write("checkpoint.1", "new");
    earlier.discard();
    const std::map<std::string, std::string> expected{
        {"run.json", "new"}, {"checkpoint.1", "new"}, {"notes.txt", "mine"}};
    CHECK(folder.files() == expected);
    CHECK_FALSE(settle_earlier_run(folder.directory(), names));
    CHECK(folder.files() == expected);
}

TEST_CASE("a new run that fails before it has begun leaves the earlier one, and what shows the failure") {
    const RunFolder folder;
    auto before = folder.files();
    {
        const EarlierRun earlier(folder.directory(), names);
        folder.write("run.json", "new");
        folder.write("failed.xyz", "new");
    }
    before["failed.xyz"] = "new";
    CHECK(folder.files() == before);
    CHECK(std::distance(fs::directory_iterator(folder / ""), fs::directory_iterator()) == 5);
}

TEST_CASE("a run that was replaced never comes back, even if it could not be removed whole") {
    const RunFolder folder;
    fs::create_directory(folder / "failed.xyz");  // which is no file that can be removed
    EarlierRun earlier(folder.directory(), names);
    folder.write("run.json", "new");
    folder.write("checkpoint.1", "new");
    earlier.discard();
    CHECK(fs::exists(folder / ".ljmd-replaced/failed.xyz"));

    fs::remove(folder / "checkpoint.1");  // by a user, when the run has ended
    CHECK_FALSE(settle_earlier_run(folder.directory(), names));
    const std::map<std::string, std::string> expected{{"run.json", "new"}, {"notes.txt", "mine"}};
    CHECK(folder.files() == expected);

    fs::remove(folder / ".ljmd-replaced/failed.xyz");
    remove_replaced_run(folder.directory(), names);
    CHECK_FALSE(fs::exists(folder / ".ljmd-replaced"));
}

TEST_CASE("a second run is replaced where not all of the first could be removed") {
    const RunFolder folder;
    fs::create_directories(folder / ".ljmd-replaced/of_another_program");
    EarlierRun earlier(folder.directory(), names);
    folder.write("run.json", "new");
    earlier.discard();
    const std::map<std::string, std::string> expected{{"run.json", "new"}, {"notes.txt", "mine"}};
    CHECK(folder.files() == expected);
    CHECK_FALSE(fs::exists(folder / ".ljmd-earlier"));
}

TEST_CASE("where there is no earlier run nothing is done") {
    const TemporaryFolder folder;
    {
        EarlierRun earlier(folder / "", names);
        CHECK(folder.count_files() == 0);
        std::ofstream(folder / "run.json") << "new";
    }
    CHECK(folder.count_files() == 1);
}

TEST_CASE("a file that cannot be looked at is not taken for one that is not there") {
    const RunFolder folder;
    const auto before = folder.files();
    const std::string too_long(300, 'x');
    CHECK_THROWS_WITH(EarlierRun(folder.directory(), {too_long}),
                      "cannot look at '" + (folder / too_long).string() + "': File name too long");
    CHECK(folder.files() == before);
}

TEST_CASE("a kill in the middle of replacing a run leaves the old one or the new one") {
    const RunFolder folder;
    const auto before = folder.files();
    const auto settle = [&] { return settle_earlier_run(folder.directory(), names); };
    CHECK_FALSE(settle());

    SECTION("while it is set aside") {
        fs::create_directory(folder / ".ljmd-moving");
        fs::rename(folder / "checkpoint.1", folder / ".ljmd-moving/checkpoint.1");
        CHECK(settle());
        CHECK(folder.files() == before);
    }
    SECTION("before the new one has a checkpoint") {
        fs::create_directory(folder / ".ljmd-earlier");
        for (const std::string name : {"run.json", "thermo.csv", "checkpoint.1"}) {
            fs::rename(folder / name, folder / ".ljmd-earlier" / name);
        }
        folder.write("run.json", "new");
        CHECK(settle());
        CHECK(folder.files() == before);
    }
    SECTION("when the new one has a checkpoint") {
        fs::create_directory(folder / ".ljmd-earlier");
        fs::rename(folder / "thermo.csv", folder / ".ljmd-earlier/thermo.csv");
        CHECK_FALSE(settle());
        auto expected = before;
        expected.erase("thermo.csv");
        CHECK(folder.files() == expected);
    }
    CHECK_FALSE(fs::exists(folder / ".ljmd-moving"));
    CHECK_FALSE(fs::exists(folder / ".ljmd-earlier"));
    CHECK_FALSE(settle());
}

TEST_CASE("what is in the folder and none of a run stays there") {
    const RunFolder folder;
    fs::create_directory(folder / ".ljmd-earlier");
    folder.write(".ljmd-earlier/notes.txt", "mine");
    for (int time = 0; time < 2; ++time) {
        CHECK_FALSE(settle_earlier_run(folder.directory(), names));
        CHECK(content_of(folder / ".ljmd-replaced/notes.txt") == "mine");
    }
}
