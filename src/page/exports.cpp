#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/verification/digits.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "page/page_run.hpp"
#include "page/phase_diagram.hpp"

/// What the page's script calls: one function that takes a request and gives an answer, both JSON, and the places of
/// what is drawn. An answer is {"value": ...}, or {"error": words, "kind": of the mistake}.
namespace {

using namespace ljmd;

std::unique_ptr<PageRun> run;

PageRun& present() {
    if (!run) {
        throw InputError("no deck was opened");
    }
    return *run;
}

std::vector<std::string> texts(const Data& list) {
    std::vector<std::string> all;
    for (const Data& item : list.items()) {
        all.push_back(item.text());
    }
    return all;
}

Data opened(const Data& request) {
    if (const Data* files = request.find("files")) {
        for (const Member& file : files->members()) {
            write_file_atomically(OutputPlace(std::filesystem::path("/" + file.key)), file.value.text());
        }
    }
    const Data* flip = request.find("flip");
    // A deck that cannot be run leaves the run before it where it is.
    auto next = std::make_unique<PageRun>(request["name"].text(), request["deck"].text(), texts(request["settings"]),
                                          request["force"].flag(), flip != nullptr ? flip->number() : -1.0);
    run = std::move(next);
    return run->description();
}

Data verified() {
    Data all = Data::list();
    for (const DigitsOfRun& digits : verify_digits({.threads = 1, .simd = SimdLevel::portable})) {
        all.push_back({{"problem", digits.problem}, {"found", digits.found}, {"right", digits.right()}});
    }
    return all;
}

Data answer_to(const Data& request) {
    const std::string& wanted = request["call"].text();
    if (wanted == "version") {
        return {{"version", build_info().version}, {"commit", build_info().commit}};
    }
    if (wanted == "open") {
        return opened(request);
    }
    if (wanted == "advance") {
        return present().advance(request["steps"].integer());
    }
    if (wanted == "result") {
        return present().result();
    }
    if (wanted == "checksum") {
        return present().checksum_data();
    }
    if (wanted == "speeds") {
        return present().speeds();
    }
    if (wanted == "configuration") {
        return present().configuration();
    }
    if (wanted == "diagram") {
        return phase_diagram();
    }
    if (wanted == "equation") {
        return equation_at(request["temperature"].number(), request["density"].number());
    }
    if (wanted == "state") {
        return state_of_fluid(request["temperature"].number(), request["density"].number());
    }
    if (wanted == "verify") {
        return verified();
    }
    throw InputError("unknown call '" + wanted + "'");
}

Data failure(const char* kind, const char* words) {
    return {{"error", words}, {"kind", kind}};
}

Data answer(std::string_view request) {
    try {
        return {{"value", answer_to(parse_json(request))}};
    } catch (const InputError& e) {
        return failure("input", e.what());
    } catch (const DataError& e) {
        return failure("data", e.what());
    } catch (const PhysicsError& e) {
        return failure("physics", e.what());
    } catch (const std::bad_alloc&) {
        return failure("memory", "there is not enough memory in this browser for that");
    } catch (const std::exception& e) {
        return failure("other", e.what());
    }
}

}  // namespace

// What is "used" Emscripten exports.
extern "C" {

/// The answer to a request, valid until the next call.
[[gnu::used]] const char* ljmd_call(const char* request) {
    static std::string text;
    text = to_json_line(answer(request));
    return text.c_str();
}

/// Brings what is drawn up to date.
[[gnu::used]] void ljmd_draw() {
    run->draw();
}

[[gnu::used]] const std::uint16_t* ljmd_positions() {
    return run->drawn_positions().data();
}

[[gnu::used]] const std::uint8_t* ljmd_speeds() {
    return run->drawn_speeds().data();
}
}
