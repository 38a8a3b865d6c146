# Plug-ins register themselves by lying in a folder: adding one is adding one file. This module writes the lists.

# ljmd_formula_list(<folder of headers> <output>): a header with `using AllFormulas = FormulaList<Type, ...>` that includes
# every header of the folder; lennard_jones.hpp declares LennardJones.
function(ljmd_formula_list folder output)
    file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/${folder}/*.hpp)
    list(SORT headers)
    set(includes "")
    set(types "")
    foreach(header IN LISTS headers)
        string(APPEND includes "#include \"${header}\"\n")
        get_filename_component(stem ${header} NAME_WE)
        string(REPLACE "_" ";" words ${stem})
        set(type "")
        foreach(word IN LISTS words)
            string(SUBSTRING ${word} 0 1 first)
            string(SUBSTRING ${word} 1 -1 rest)
            string(TOUPPER ${first} first)
            string(APPEND type ${first}${rest})
        endforeach()
        list(APPEND types ${type})
    endforeach()
    list(JOIN types ", " types)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/include/${output} CONTENT
"#pragma once
// Written by cmake/LjmdRegistries.cmake from the headers in include/${folder}.
@includes@
namespace ljmd {

template <class... Formulas>
struct FormulaList {};

using AllFormulas = FormulaList<@types@>;

}  // namespace ljmd
" @ONLY)
endfunction()

# ljmd_plugin_list(<folder of sources> <plug-in type> <header> <function> <variable>): a source file that defines
# `std::vector<Type> function()`; every x.cpp in the folder defines `Type x();`. Its path is appended to variable.
function(ljmd_plugin_list folder type header function variable)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
    list(SORT sources)
    set(declarations "")
    set(calls "")
    foreach(source IN LISTS sources)
        get_filename_component(stem ${source} NAME_WE)
        string(APPEND declarations "${type} ${stem}();\n")
        list(APPEND calls "${stem}()")
    endforeach()
    list(JOIN calls ", " calls)
    set(path ${PROJECT_BINARY_DIR}/generated/src/${function}.cpp)
    file(CONFIGURE OUTPUT ${path} CONTENT
"// Written by cmake/LjmdRegistries.cmake from the files in src/${folder}.
#include \"${header}\"

namespace ljmd {

@declarations@
std::vector<${type}> ${function}() { return {@calls@}; }

}  // namespace ljmd
" @ONLY)
    set(${variable} ${${variable}} ${path} PARENT_SCOPE)
endfunction()

ljmd_formula_list(ljmd/detail/potentials/formulas ljmd/detail/potentials/formula_list.hpp)
ljmd_plugin_list(cli/commands std::shared_ptr<Command> cli/command.hpp all_commands ljmd_program_registries)
ljmd_plugin_list(forces/few_body FewBodyForceMethod forces/few_body_force.hpp all_few_body_forces ljmd_engine_registries)
ljmd_plugin_list(integrators/methods IntegratorMethod integrators/integrator.hpp all_integrators ljmd_engine_registries)
ljmd_plugin_list(integrators/barostats BarostatMethod integrators/barostat.hpp all_barostats ljmd_engine_registries)
ljmd_plugin_list(integrators/thermostats ThermostatMethod integrators/thermostat.hpp all_thermostats ljmd_engine_registries)
ljmd_plugin_list(io/formats/readable ReadableFormat io/formats/readable_format.hpp all_readable_formats ljmd_file_registries)
ljmd_plugin_list(io/formats/trajectories TrajectoryFormat io/formats/trajectory_writer.hpp all_trajectory_formats ljmd_file_registries)
ljmd_plugin_list(observables/analyses AnalysisMethod ljmd/detail/observables/analysis.hpp all_analyses ljmd_engine_registries)
ljmd_plugin_list(observables/few_body_analyses FewBodyAnalysisMethod observables/few_body/few_body_analysis.hpp all_few_body_analyses ljmd_engine_registries)
ljmd_plugin_list(reference/equations EquationOfState ljmd/detail/reference/equation_of_state.hpp all_equations_of_state ljmd_engine_registries)
