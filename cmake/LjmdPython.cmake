# The Python package `ljmd`: the extension ljmd/_core and the sources in python/ljmd, put together in
# <build>/python/ljmd, so that it can be imported without being installed (tools/python). Its part that reads results is
# Python alone. The scripts in analysis/ use it, and it is installed for them also without the extension.
#
# LJMD_BUILD_PYTHON=AUTO builds it where Python's and pybind11's headers are found, but not under a sanitizer or for coverage,
# whose run-time library an ordinary Python does not have.
set(ljmd_python_wanted ${LJMD_BUILD_PYTHON})
if(LJMD_BUILD_PYTHON STREQUAL AUTO AND (NOT LJMD_PROGRAM OR CMAKE_CXX_FLAGS MATCHES "-fsanitize|--coverage"))
    set(ljmd_python_wanted OFF)
endif()

# The Python of the analysis scripts: what has numpy has to be what the extension is compiled for.
set(LJMD_PYTHON "" CACHE FILEPATH "Python with numpy, h5py and matplotlib; for the tests also with MDAnalysis and ASE")
if(ljmd_python_wanted AND NOT LJMD_PYTHON)
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/find-python OUTPUT_VARIABLE found ERROR_QUIET
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
    set_property(CACHE LJMD_PYTHON PROPERTY VALUE "${found}")
endif()

set(ljmd_build_python OFF)
if(ljmd_python_wanted)
    if(LJMD_PYTHON)
        set(Python3_EXECUTABLE ${LJMD_PYTHON})
    endif()
    find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
    set(PYBIND11_NOPYTHON ON)
    find_package(pybind11 2.10 QUIET CONFIG)
    if(Python3_FOUND AND pybind11_FOUND)
        set(ljmd_build_python ON)
        message(STATUS "The Python package is built for ${Python3_EXECUTABLE} (${Python3_VERSION})")
    elseif(NOT ljmd_python_wanted STREQUAL AUTO)
        message(FATAL_ERROR "The Python package takes the headers of Python 3.9 or later and of pybind11 2.10 or later. "
                            "-D LJMD_BUILD_PYTHON=OFF builds without it.")
    else()
        message(STATUS "The Python package is not built: it takes the headers of Python 3.9 and of pybind11 2.10")
    endif()
endif()

# Python with the address sanitizer's library preloaded starts the program, which must not bring a second one: clang links
# it statically unless told otherwise. (tests/python preloads it.)
if(ljmd_build_python AND CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address")
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so
                    OUTPUT_VARIABLE ljmd_asan OUTPUT_STRIP_TRAILING_WHITESPACE)
    cmake_path(GET ljmd_asan PARENT_PATH ljmd_asan_folder)
    add_link_options(-shared-libasan LINKER:-rpath,${ljmd_asan_folder})
endif()

# ljmd_for_extension(<target>...): their objects can be part of a shared library. They export nothing and nobody
# replaces their functions, so that the compiler inlines and calls as it does for a program.
function(ljmd_for_extension)
    if(ljmd_build_python OR BUILD_SHARED_LIBS)
        set_target_properties(${ARGN} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        if(NOT BUILD_SHARED_LIBS)
            set_target_properties(${ARGN} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
        endif()
        foreach(target IN LISTS ARGN)
            target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-fno-semantic-interposition>)
        endforeach()
    endif()
endfunction()

# Called when ljmd_program is there.
function(ljmd_add_python_package)
    set(package ${PROJECT_BINARY_DIR}/python/ljmd)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/python/*.cpp)
    Python3_add_library(ljmd_python MODULE WITH_SOABI ${sources})
    ljmd_compile_together(ljmd_python ${sources})
    target_link_libraries(ljmd_python PRIVATE pybind11::headers ljmd_program ljmd_options fmt::fmt)
    set_target_properties(ljmd_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${package}
                                                 CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    ljmd_finds_libraries(ljmd_python ${LJMD_PYTHON_SITE}/ljmd)
    # What the archive exports would take the place of functions of other extensions, or give way to them.
    if(NOT APPLE)
        target_link_options(ljmd_python PRIVATE LINKER:--exclude-libs,ALL)
    endif()

    # Sources are links, so that a change of one takes effect at once.
    ljmd_python_sources(modules)
    foreach(module IN LISTS modules)
        get_filename_component(folder ${package}/${module} DIRECTORY)
        file(MAKE_DIRECTORY ${folder})
        file(CREATE_LINK ${PROJECT_SOURCE_DIR}/python/ljmd/${module} ${package}/${module} COPY_ON_ERROR SYMBOLIC)
    endforeach()

    if(LJMD_INSTALL)
        install(TARGETS ljmd_python DESTINATION ${LJMD_PYTHON_SITE}/ljmd COMPONENT python)
    endif()
endfunction()

# The files of the package but for the extension, relative to its folder.
function(ljmd_python_sources variable)
    set(package ${PROJECT_SOURCE_DIR}/python/ljmd)
    file(GLOB_RECURSE modules CONFIGURE_DEPENDS RELATIVE ${package} ${package}/*.py ${package}/*.pyi ${package}/*.mplstyle
         ${package}/py.typed)
    set(${variable} ${modules} PARENT_SCOPE)
endfunction()

# The sources of the package, once: where Python looks for packages; without the extension beside analysis/, whose scripts
# look for the package in ../python. With it they find a link there, which holds when the installed tree is moved.
function(ljmd_install_python_sources)
    set(beside ${CMAKE_INSTALL_DATADIR}/ljmd/python)
    set(place ${beside})
    set(component "")
    # What an earlier installation has put there may be the other of link and folder.
    install(CODE "set(beside \"${beside}/ljmd\")
cmake_path(ABSOLUTE_PATH beside BASE_DIRECTORY \"\${CMAKE_INSTALL_PREFIX}\")
file(REMOVE_RECURSE \"\$ENV{DESTDIR}\${beside}\")")
    if(ljmd_build_python)
        set(component COMPONENT python)
        set(place ${LJMD_PYTHON_SITE})
        cmake_path(ABSOLUTE_PATH place BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE site)
        file(RELATIVE_PATH target ${CMAKE_INSTALL_FULL_DATADIR}/ljmd/python ${site}/ljmd)
        set(link ${PROJECT_BINARY_DIR}/generated/installed/ljmd)
        file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/generated/installed)
        file(CREATE_LINK ${target} ${link} SYMBOLIC)
        install(FILES ${link} DESTINATION ${beside})
    endif()
    ljmd_python_sources(modules)
    foreach(module IN LISTS modules)
        get_filename_component(folder ${module} DIRECTORY)
        install(FILES ${PROJECT_SOURCE_DIR}/python/ljmd/${module} DESTINATION ${place}/ljmd/${folder} ${component})
    endforeach()
endfunction()

# Where Python looks for packages, below the prefix: lib/python3.11/site-packages, on Debian .../dist-packages.
if(ljmd_build_python AND NOT LJMD_PYTHON_SITE)
    execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys, sysconfig
site = sysconfig.get_path('platlib')
site = site[len(sys.prefix):].lstrip('/') if site.startswith(sys.prefix) else 'lib/python3/site-packages'
print(site[len('local/'):] if site.startswith('local/') else site, end='')"
                    OUTPUT_VARIABLE site COMMAND_ERROR_IS_FATAL ANY)
    set(LJMD_PYTHON_SITE ${site} CACHE STRING "Folder of Python packages below the prefix")
endif()
