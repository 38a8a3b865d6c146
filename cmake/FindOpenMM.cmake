# OpenMM has no configuration for CMake and no pkg-config file of its own.
#
#   OpenMM::OpenMM           target to link
#   OpenMM_VERSION           as the library says itself: Platform::getOpenMMVersion()
#   OpenMM_PLUGIN_DIR        folder of its platforms: openmm/plugins beside the library on Debian, plugins elsewhere
#   OpenMM_INCLUDE_DIR, OpenMM_LIBRARY
#
# OpenMM_ROOT, or a conda environment that is active, is looked in first.
find_path(OpenMM_INCLUDE_DIR OpenMM.h HINTS ENV CONDA_PREFIX PATH_SUFFIXES include)
find_library(OpenMM_LIBRARY OpenMM HINTS ENV CONDA_PREFIX PATH_SUFFIXES lib)
mark_as_advanced(OpenMM_INCLUDE_DIR OpenMM_LIBRARY)

if(OpenMM_INCLUDE_DIR AND OpenMM_LIBRARY)
    get_filename_component(OpenMM_library_dir ${OpenMM_LIBRARY} DIRECTORY)
    find_path(OpenMM_PLUGIN_DIR NAMES libOpenMMCPU.so libOpenMMCPU.dylib
              PATHS ${OpenMM_library_dir}/openmm/plugins ${OpenMM_library_dir}/plugins NO_DEFAULT_PATH)
    mark_as_advanced(OpenMM_PLUGIN_DIR)

    # Only the library knows its version. Where its programs cannot be run the version stays unknown.
    if(NOT DEFINED OpenMM_VERSION)
        set(OpenMM_version_source ${CMAKE_CURRENT_BINARY_DIR}/openmm_version.cpp)
        file(WRITE ${OpenMM_version_source} "#include <OpenMM.h>
#include <iostream>
int main() { std::cout << OpenMM::Platform::getOpenMMVersion(); }
")
        try_run(OpenMM_version_run OpenMM_version_compiled ${CMAKE_CURRENT_BINARY_DIR} ${OpenMM_version_source}
                CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${OpenMM_INCLUDE_DIR}
                LINK_LIBRARIES ${OpenMM_LIBRARY}
                CXX_STANDARD 17
                RUN_OUTPUT_VARIABLE OpenMM_version_text)
        if(OpenMM_version_compiled AND OpenMM_version_run EQUAL 0 AND OpenMM_version_text MATCHES "^[0-9.]+")
            set(OpenMM_VERSION ${CMAKE_MATCH_0} CACHE INTERNAL "Version of OpenMM")
        endif()
    endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenMM REQUIRED_VARS OpenMM_LIBRARY OpenMM_INCLUDE_DIR OpenMM_PLUGIN_DIR
                                  VERSION_VAR OpenMM_VERSION)

if(OpenMM_FOUND AND NOT TARGET OpenMM::OpenMM)
    add_library(OpenMM::OpenMM SHARED IMPORTED)
    set_target_properties(OpenMM::OpenMM PROPERTIES IMPORTED_LOCATION ${OpenMM_LIBRARY}
                                                    INTERFACE_INCLUDE_DIRECTORIES ${OpenMM_INCLUDE_DIR})
endif()
