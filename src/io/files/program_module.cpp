#include "io/files/program_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <utility>

#if defined(__APPLE__)
#include <mach-o/dyld.h>

#include <array>
#elif defined(__linux__)
#include <sys/auxv.h>
#endif

#include "io/files/file_system.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

std::filesystem::path this_program() {
#if defined(__APPLE__)
    std::array<char, 4096> name{};
    auto size = static_cast<std::uint32_t>(name.size());
    if (::_NSGetExecutablePath(name.data(), &size) == 0) {
        return files::canonical(name.data());
    }
#elif defined(__linux__)
    if (files::exists("/proc/self/exe")) {
        return files::read_link("/proc/self/exe");
    }
    // No /proc: what the kernel was told to start, as seen from the directory of the first call.
    static const std::filesystem::path started =
        files::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)));  // NOLINT(performance-no-int-to-ptr)
    return started;
#endif
    throw FileError("it is not known where this program is");
}

ProgramModule::ProgramModule(std::string library, std::string packages, const std::filesystem::path& file)
    : library_(std::move(library)), packages_(std::move(packages)) {
    const std::filesystem::path folder = this_program().parent_path();
    path_ = folder / file;
    if (!is_there()) {
        path_ = (folder / LJMD_MODULES_FROM_PROGRAM / file).lexically_normal();
    }
}

bool ProgramModule::is_there() const {
    return files::is_regular_file(path_);
}

void* ProgramModule::symbol(const char* name) const {
    if (!is_there()) {
        throw InputError(fmt::format(
            "this ljmd was built without {}: there is no {}; install it (Debian: apt-get install {}) and build again",
            library_, path_.string(), packages_));
    }
    // What these libraries load themselves looks for their symbols.
    void* module = ::dlopen(path_.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr) {
        throw InputError(
            fmt::format("the part of ljmd for {}, {}, cannot be loaded: {}", library_, path_.string(), ::dlerror()));
    }
    void* symbol = ::dlsym(module, name);
    if (symbol == nullptr) {
        throw InputError(fmt::format("{} is not the part of ljmd for {}", path_.string(), library_));
    }
    return symbol;
}

}  // namespace ljmd
