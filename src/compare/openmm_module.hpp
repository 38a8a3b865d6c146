#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/openmm.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// A fluid with what only functions of the program tell of its potential, because the module calls none of them.
struct OpenmmFluid : Fluid {
    std::string expression;      ///< see openmm_expression()
    std::string formula;         ///< the same without truncation
    PairTerm<double> at_cutoff;  ///< of the formula
};

/// @throws InputError as openmm_expression()
[[nodiscard]] OpenmmFluid openmm_fluid(const Fluid& fluid);

/// What the module for OpenMM offers. Its errors are ljmd's: types of exceptions are compared by their names.
class OpenmmModule {
  public:
    virtual ~OpenmmModule() = default;
    OpenmmModule(const OpenmmModule&) = delete;
    OpenmmModule& operator=(const OpenmmModule&) = delete;

    /// Of the library that is loaded.
    [[nodiscard]] virtual std::string version() const = 0;
    /// Where the plug-ins of the library are that the module was built with.
    [[nodiscard]] virtual std::string plugin_folder() const = 0;
    /// One that cannot be loaded, for example for missing hardware, is skipped.
    virtual void load_plugin(const std::string& file) const = 0;
    /// Those that are loaded.
    [[nodiscard]] virtual std::vector<std::string> platforms() const = 0;
    /// As make_openmm_peer(), and as openmm_xml(). @pre the platform is one of platforms()
    [[nodiscard]] virtual std::unique_ptr<Peer> peer(OpenmmFluid fluid, const OpenmmOptions& options) const = 0;
    [[nodiscard]] virtual OpenmmXml xml(const OpenmmFluid& fluid, double time_step) const = 0;

  protected:
    OpenmmModule() = default;
};

/// The module, which lives as long as the program.
extern "C" const OpenmmModule* ljmd_openmm();

inline constexpr const char* openmm_module_function = "ljmd_openmm";

}  // namespace ljmd
