#include "ljmd/io/files/program_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"

namespace ljmd {

std::filesystem::path this_program() {
    return files::read_link("/proc/self/exe");
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
