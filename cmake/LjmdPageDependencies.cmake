# In place of LjmdDependencies where the engine is compiled for a page: what tools/page-root has put together.
enable_language(C)
set(ljmd_page_root ${PROJECT_SOURCE_DIR}/build/page-root CACHE PATH "What tools/page-root has made")
add_library(Threads::Threads INTERFACE IMPORTED)

# ljmd_page_headers(<target> <definition>...): a library of headers alone.
function(ljmd_page_headers target)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/src/page/compat ${PROJECT_SOURCE_DIR}/src/core/compat
                                                          ${ljmd_page_root}/include ${ljmd_page_root}/eigen3)
    target_compile_definitions(${target} INTERFACE ${ARGN})
endfunction()
# Indices are of 64 bits here, too.
ljmd_page_headers(Eigen3::Eigen EIGEN_DEFAULT_DENSE_INDEX_TYPE=std::int64_t)
ljmd_page_headers(fmt::fmt FMT_HEADER_ONLY)
ljmd_page_headers(PkgConfig::xxhash XXH_INLINE_ALL)
ljmd_page_headers(PkgConfig::tomlplusplus TOML_HEADER_ONLY=1 TOML_FLOAT_CHARCONV=1)  # streams refuse 1e-320
ljmd_page_headers(nlohmann_json::nlohmann_json)
ljmd_page_headers(PkgConfig::fftw3)  # src/page/fourier.cpp is in its place

# What ljmd calls of GSL, and what that calls.
set(folder ${ljmd_page_root}/gsl)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/gsl/config.h CONTENT
"#define GSL_DISABLE_DEPRECATED 1
#define HAVE_INLINE 1
#define HAVE_C99_INLINE 1
#define HAVE_DECL_ISNAN 1
#define HAVE_DECL_ISINF 1
#define HAVE_DECL_FINITE 1
#define HAVE_DECL_ISFINITE 1
#define HAVE_IEEE_COMPARISONS 1
#define HAVE_IEEE_DENORMALS 1
#define HAVE_EXTENDED_PRECISION_REGISTERS 0
#define GSL_COERCE_DBL(x) (x)
#define RETURN_IF_NULL(x) if (!x) { return ; }
")
set(sources err/error err/stream err/strerror err/message sys/infnan sys/fdiv sys/coerce
            integration/qag integration/qags integration/qk integration/qk15 integration/qk21 integration/qk31
            integration/qk41 integration/qk51 integration/qk61 integration/workspace
            roots/fsolver roots/brent roots/convergence
            ode-initval2/driver ode-initval2/evolve ode-initval2/control ode-initval2/cstd ode-initval2/step
            ode-initval2/rk8pd)
list(TRANSFORM sources PREPEND ${folder}/)
list(TRANSFORM sources APPEND .c)
add_library(ljmd_gsl STATIC ${sources})
add_library(GSL::gsl ALIAS ljmd_gsl)
target_include_directories(ljmd_gsl PRIVATE ${PROJECT_BINARY_DIR}/gsl ${folder} PUBLIC ${ljmd_page_root}/include)
target_compile_options(ljmd_gsl PRIVATE -w -ffp-contract=off)
