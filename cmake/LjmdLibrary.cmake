# The libraries, each upon the one before it, and the program:
#
#   ljmd::engine   runs in memory: the rooms from core to engine. No file, no deck, no process.
#   ljmd::ljmd     runs with a directory: decks, formats of files, analyses of what a run has left
#   ljmd_program   what the program consists of, for it, its tests and the Python package; it is not installed
#
# BUILD_SHARED_LIBS decides whether the first two are shared. LJMD_FILES=OFF builds the first alone.
set(ljmd_engine_rooms core options execution model reference potentials neighbors forces integrators observables
                      engine)
set(ljmd_file_rooms io input deck run analyze)
set(ljmd_program_rooms compare judge study report cli)

# ljmd_sources_of(<variable> <room>...): their sources, but for kernels and modules.
function(ljmd_sources_of variable)
    list(TRANSFORM ARGN APPEND /*.cpp)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/src/)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${ARGN})
    list(REMOVE_ITEM sources ${ljmd_simd_sources})
    list(FILTER sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/src/(execution/mpi|compare/openmm)/")
    set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# ljmd_finds_libraries(<target> <folder>): installed there, it finds the shared libraries of this project by their place
# relative to its own.
function(ljmd_finds_libraries target folder)
    if(BUILD_SHARED_LIBS)
        cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
        file(RELATIVE_PATH libraries ${folder} ${CMAKE_INSTALL_FULL_LIBDIR})
        string(REGEX REPLACE "/$" "" place "$ORIGIN/${libraries}")
        set_target_properties(${target} PROPERTIES INSTALL_RPATH "${place}")
    endif()
endfunction()

# ljmd_part(<target> <kind, or nothing> <source>...)
function(ljmd_part target kind)
    add_library(${target} ${kind} ${ARGN})
    ljmd_for_extension(${target})
    ljmd_compile_together(${target} ${ARGN})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target}
        PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
               $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated/include>
               $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
        PRIVATE ${ljmd_version_include})
    # This project's own options are no business of who links an installed ljmd; nor are libraries of headers alone.
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:ljmd_options> fmt::fmt)
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
                                               DEFINE_SYMBOL "")  # a precompiled header serves both
    get_target_property(type ${target} TYPE)
    if(type STREQUAL SHARED_LIBRARY AND NOT APPLE)
        # What is of ljmd is seen from outside, and nothing of the libraries that it is built on.
        target_link_options(${target} PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/exported.map)
        set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exported.map)
    endif()
endfunction()

ljmd_sources_of(ljmd_engine_sources ${ljmd_engine_rooms})
# A page has its own transforms, and so has their test: an object by itself can be left out.
set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/observables/fourier.cpp PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
if(EMSCRIPTEN)
    list(TRANSFORM ljmd_engine_sources REPLACE /observables/fourier.cpp$ /page/fourier.cpp)
endif()
ljmd_part(ljmd_engine "" ${ljmd_engine_sources} ${ljmd_engine_registries} ${ljmd_simd_objects})
add_library(ljmd::engine ALIAS ljmd_engine)
set_target_properties(ljmd_engine PROPERTIES EXPORT_NAME engine)
target_precompile_headers(ljmd_engine PRIVATE ${ljmd_precompiled_headers})
add_dependencies(ljmd_engine ljmd_version_header)
target_link_libraries(ljmd_engine
    PUBLIC Eigen3::Eigen
    PRIVATE Threads::Threads GSL::gsl PkgConfig::fftw3 PkgConfig::xxhash)

if(LJMD_FILES)
    ljmd_sources_of(ljmd_file_sources ${ljmd_file_rooms})
    ljmd_part(ljmd_library "" ${ljmd_file_sources} ${ljmd_file_registries})
    add_library(ljmd::ljmd ALIAS ljmd_library)
    set_target_properties(ljmd_library PROPERTIES OUTPUT_NAME ljmd EXPORT_NAME ljmd)
    ljmd_finds_libraries(ljmd_library ${CMAKE_INSTALL_LIBDIR})
    target_precompile_headers(ljmd_library REUSE_FROM ljmd_engine)
    target_link_libraries(ljmd_library
        PUBLIC ljmd_engine
        PRIVATE $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> PkgConfig::tomlplusplus PkgConfig::xxhash hdf5::hdf5
                ZLIB::ZLIB Threads::Threads ${CMAKE_DL_LIBS})
    # Modules: beside the program in the build, in a folder of their own when installed.
    file(RELATIVE_PATH ljmd_modules_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/ljmd)
    set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/io/files/program_module.cpp
                 APPEND PROPERTY COMPILE_DEFINITIONS LJMD_MODULES_FROM_PROGRAM="${ljmd_modules_from_program}")
endif()
if(NOT LJMD_PROGRAM)
    return()
endif()

set(ljmd_main ${PROJECT_SOURCE_DIR}/src/cli/main.cpp)
ljmd_sources_of(ljmd_program_sources ${ljmd_program_rooms})
list(REMOVE_ITEM ljmd_program_sources ${ljmd_main})
ljmd_part(ljmd_program STATIC ${ljmd_program_sources} ${ljmd_program_registries})
target_precompile_headers(ljmd_program REUSE_FROM ljmd_engine)
target_link_libraries(ljmd_program PUBLIC ljmd_library PRIVATE CLI11::CLI11 GSL::gsl PkgConfig::xxhash Threads::Threads ZLIB::ZLIB)
# The page of `ljmd report`, as arrays. Its script stands in the sources as one can read it; esbuild makes it half as long.
set(ljmd_page ${PROJECT_SOURCE_DIR}/src/report/web/dist)
set(ljmd_page_script ${ljmd_page}/report.js)
if(ljmd_esbuild)
    set(ljmd_page_script ${PROJECT_BINARY_DIR}/generated/page/report.js)
    add_custom_command(OUTPUT ${ljmd_page_script}
        COMMAND ${ljmd_esbuild} ${ljmd_page}/report.js --minify --charset=utf8 --legal-comments=inline --log-level=error
                --outfile=${ljmd_page_script}
        DEPENDS ${ljmd_page}/report.js VERBATIM)
endif()
set(ljmd_page_arrays ${ljmd_version_include}/report/page_arrays.hpp)
add_custom_command(OUTPUT ${ljmd_page_arrays}
    COMMAND ${CMAKE_COMMAND} -D frame=${ljmd_page}/index.html -D style=${ljmd_page}/report.css -D script=${ljmd_page_script}
            -D output=${ljmd_page_arrays} -P ${PROJECT_SOURCE_DIR}/cmake/WritePageArrays.cmake
    DEPENDS ${ljmd_page}/index.html ${ljmd_page}/report.css ${ljmd_page_script}
            ${PROJECT_SOURCE_DIR}/cmake/WritePageArrays.cmake
    VERBATIM)
add_custom_target(ljmd_page_arrays DEPENDS ${ljmd_page_arrays})
add_dependencies(ljmd_program ljmd_page_arrays)

# `ljmd plot` finds its scripts by the place of the program: after installation below this folder, before it by a link.
file(RELATIVE_PATH ljmd_data_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/ljmd)
set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/cli/plot_scripts.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS LJMD_DATA_FROM_PROGRAM="${ljmd_data_from_program}")
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/analysis ${PROJECT_BINARY_DIR}/analysis SYMBOLIC)

# ljmd_module(<name> <whether its library was found> <folder of src> <library>...): what needs a library that may be absent.
# The program loads it when it is asked for; what it needs of ljmd are headers. One of an earlier configuration would be
# loaded, too.
set(ljmd_modules "")
function(ljmd_module name found folder)
    if(NOT found)
        file(REMOVE ${PROJECT_BINARY_DIR}/${name}.so)
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
    add_library(${name} MODULE ${sources})
    set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/generated/include)
    target_compile_features(${name} PRIVATE cxx_std_20)
    target_link_libraries(${name} PRIVATE ljmd_options ${ARGN})
    list(APPEND ljmd_modules ${name})
    set(ljmd_modules ${ljmd_modules} PARENT_SCOPE)
endfunction()
ljmd_module(ljmd_mpi "${MPI_CXX_FOUND}" execution/mpi MPI::MPI_CXX)
ljmd_module(ljmd_openmm "${OpenMM_FOUND}" compare/openmm OpenMM::OpenMM Eigen3::Eigen fmt::fmt)
if(OpenMM_FOUND)
    target_compile_definitions(ljmd_openmm PRIVATE LJMD_OPENMM_PLUGIN_DIR="${OpenMM_PLUGIN_DIR}")
    get_target_property(openmm_sources ljmd_openmm SOURCES)
    ljmd_includes_openmm(${openmm_sources})
endif()

add_executable(ljmd ${ljmd_main})
if(ljmd_modules)
    add_dependencies(ljmd ${ljmd_modules})
endif()
ljmd_finds_libraries(ljmd ${CMAKE_INSTALL_BINDIR})
target_link_libraries(ljmd PRIVATE ljmd_program ljmd_options)
