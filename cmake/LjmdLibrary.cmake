# The library ljmd::ljmd and the program ljmd.
file(GLOB_RECURSE ljmd_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
# The command line is read by the program alone.
set(ljmd_program_sources main.cpp described_commands.cpp own_commands.cpp evaluate/evaluate_options.cpp)
list(TRANSFORM ljmd_program_sources PREPEND ${PROJECT_SOURCE_DIR}/src/cli/)
list(REMOVE_ITEM ljmd_sources ${ljmd_program_sources} ${ljmd_simd_sources})
list(FILTER ljmd_sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/src/python/")

# What needs MPI is a module of its own.
list(FILTER ljmd_sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/src/execution/mpi/")

# What needs a library that may be absent has a stand-in that says so.
if(OpenMM_FOUND)
    set(ljmd_unused_sources ${PROJECT_SOURCE_DIR}/src/compare/openmm_absent/)
else()
    set(ljmd_unused_sources ${PROJECT_SOURCE_DIR}/src/compare/openmm/)
endif()
list(FILTER ljmd_sources EXCLUDE REGEX "^${ljmd_unused_sources}")

add_library(ljmd_library STATIC ${ljmd_sources} ${ljmd_generated_sources} ${ljmd_simd_objects})
add_library(ljmd::ljmd ALIAS ljmd_library)
ljmd_for_extension(ljmd_library)
target_precompile_headers(ljmd_library PRIVATE ${ljmd_precompiled_headers})
ljmd_compile_together(ljmd_library ${ljmd_sources})
add_dependencies(ljmd_library ljmd_version_header)
# The page of `ljmd report`, which the assembler includes.
set(ljmd_bundle ${PROJECT_SOURCE_DIR}/src/report/web/dist)
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/report/page_bundle.cpp PROPERTIES
    COMPILE_DEFINITIONS LJMD_REPORT_BUNDLE="${ljmd_bundle}"
    OBJECT_DEPENDS "${ljmd_bundle}/index.html;${ljmd_bundle}/report.css;${ljmd_bundle}/report.js"
    SKIP_UNITY_BUILD_INCLUSION ON)
set_target_properties(ljmd_library PROPERTIES OUTPUT_NAME ljmd EXPORT_NAME ljmd)
target_compile_features(ljmd_library PUBLIC cxx_std_20)
target_include_directories(ljmd_library
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
           $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${ljmd_version_include})
target_include_directories(ljmd_library SYSTEM PRIVATE ${RANDOM123_INCLUDE_DIR})
# Libraries of headers alone, and this project's own options, are no business of who links an installed ljmd.
target_link_libraries(ljmd_library
    PUBLIC Eigen3::Eigen
    PRIVATE $<BUILD_INTERFACE:ljmd_options> $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>
            fmt::fmt Threads::Threads GSL::gsl PkgConfig::fftw3 PkgConfig::tomlplusplus PkgConfig::xxhash hdf5::hdf5
            ZLIB::ZLIB)
if(OpenMM_FOUND)
    target_link_libraries(ljmd_library PRIVATE OpenMM::OpenMM)
    set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/compare/openmm/openmm_platforms.cpp
                 APPEND PROPERTY COMPILE_DEFINITIONS LJMD_OPENMM_PLUGIN_DIR="${OpenMM_PLUGIN_DIR}")
    file(GLOB openmm_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/compare/openmm/*.cpp)
    ljmd_includes_openmm(${openmm_sources})
endif()

# `ljmd plot` finds its scripts by the place of the program: after installation below this folder, before it by a link.
file(RELATIVE_PATH ljmd_data_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/ljmd)
set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/cli/plot_scripts.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS LJMD_DATA_FROM_PROGRAM="${ljmd_data_from_program}")
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/analysis ${PROJECT_BINARY_DIR}/analysis SYMBOLIC)

# Beside the program in the build, in a folder of its own when installed.
file(RELATIVE_PATH ljmd_modules_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/ljmd)
set_property(SOURCE ${PROJECT_SOURCE_DIR}/src/cli/ranks.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS LJMD_MODULES_FROM_PROGRAM="${ljmd_modules_from_program}")
if(MPI_CXX_FOUND)
    add_library(ljmd_mpi MODULE ${PROJECT_SOURCE_DIR}/src/execution/mpi/mpi_ranks.cpp)
    set_target_properties(ljmd_mpi PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden)
    target_include_directories(ljmd_mpi PRIVATE ${PROJECT_SOURCE_DIR}/include)
    target_compile_features(ljmd_mpi PRIVATE cxx_std_20)
    target_link_libraries(ljmd_mpi PRIVATE ljmd_options MPI::MPI_CXX)
endif()

add_executable(ljmd ${ljmd_program_sources})
if(TARGET ljmd_mpi)
    add_dependencies(ljmd ljmd_mpi)
endif()
target_link_libraries(ljmd PRIVATE ljmd_library ljmd_options CLI11::CLI11 fmt::fmt)
# They read the command line, once, and optimizing what CLI11 makes of that takes as long as the rest of a room.
set_property(SOURCE ${ljmd_program_sources} APPEND PROPERTY COMPILE_OPTIONS $<$<NOT:$<CONFIG:Debug>>:-O1>)
