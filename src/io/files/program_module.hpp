#pragma once

#include <filesystem>
#include <string>

namespace ljmd {

/// The executable file of this program. @throws FileError
[[nodiscard]] std::filesystem::path this_program();

/// A part of the program that is built on a library which a computer may be without: a file that is loaded when it is
/// asked for. It lies beside the program in a build, and in the folder ljmd of the libraries when installed. It needs
/// no function of the program: what it is told are values, and what it offers is one function of C.
class ProgramModule {
  public:
    /// @param library   that it is built on, in messages: "MPI"
    /// @param packages  of Debian, that it is built with
    /// @param file      its name: "ljmd_mpi.so", or an absolute path
    ProgramModule(std::string library, std::string packages, const std::filesystem::path& file);

    /// Where it is, or would be.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] bool is_there() const;

    /// Load it. It stays loaded.
    /// @param name  of its function
    /// @throws InputError  it is not there, cannot be loaded or has no such function
    template <class Function>
    [[nodiscard]] Function* function(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

  private:
    [[nodiscard]] void* symbol(const char* name) const;

    std::string library_;
    std::string packages_;
    std::filesystem::path path_;
};

}  // namespace ljmd
