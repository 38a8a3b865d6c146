# What 'cmake --install' puts where: program, library, headers, the packages by which CMake and pkg-config find the
# library, decks, analysis scripts, documentation. The Python package: cmake/LjmdPython.cmake; the manual page and
# completion: cmake/LjmdPages.cmake.
include(CMakePackageConfigHelpers)
set(ljmd_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ljmd)

if(LJMD_PROGRAM)
    install(TARGETS ljmd DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
if(ljmd_modules)
    install(TARGETS ${ljmd_modules} DESTINATION ${CMAKE_INSTALL_LIBDIR}/ljmd)
endif()
set(needs_files "")
if(LJMD_FILES)
    install(TARGETS ljmd_library EXPORT ljmd DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT ljmd NAMESPACE ljmd:: FILE ljmdTargets.cmake DESTINATION ${ljmd_package_dir})
else()
    set(needs_files PATTERN ljmd.hpp EXCLUDE PATTERN run EXCLUDE PATTERN deck EXCLUDE)
endif()
install(TARGETS ljmd_engine EXPORT ljmd_engine DESTINATION ${CMAKE_INSTALL_LIBDIR})
# Public is what lies in include/, and the one header that is generated for it.
install(DIRECTORY include/ljmd DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" ${needs_files})
install(FILES ${PROJECT_BINARY_DIR}/generated/include/ljmd/detail/potentials/formula_list.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ljmd/detail/potentials)
if(LJMD_PROGRAM)
    install(DIRECTORY inputs analysis DESTINATION ${CMAKE_INSTALL_DATADIR}/ljmd COMPONENT program PATTERN "__pycache__" EXCLUDE)
    ljmd_install_python_sources()
endif()
install(FILES README.md LICENSE CITATION.cff CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The notebook, measurements and trials, is for those who work on the code; the paper is for a journal.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "notebook" EXCLUDE PATTERN "paper" EXCLUDE)

# Made by tools/page, with another compiler: installed where it is there.
install(FILES build/page/ljmd.html DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs OPTIONAL)

install(EXPORT ljmd_engine NAMESPACE ljmd:: FILE ljmdEngineTargets.cmake DESTINATION ${ljmd_package_dir})
configure_package_config_file(cmake/ljmdConfig.cmake.in ljmdConfig.cmake INSTALL_DESTINATION ${ljmd_package_dir})
write_basic_package_version_file(ljmdConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ljmdConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ljmdConfigVersion.cmake
        DESTINATION ${ljmd_package_dir})

# Files of pkg-config say where things are relative to themselves, so that an installed tree can be moved.
file(RELATIVE_PATH ljmd_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH ljmd_pc_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH ljmd_pc_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
string(REGEX REPLACE "/$" "" ljmd_pc_prefix ${ljmd_pc_prefix})
# ljmd_pc_file(<name> <description> <library> <public modules> <private modules> <private libraries>)
function(ljmd_pc_file name description library modules private_modules private_libraries)
    if(BUILD_SHARED_LIBS)  # the library brings what it needs; pkg-config would ask for the headers of all of it
        set(private_modules "")
        set(private_libraries "")
    endif()
    configure_file(cmake/ljmd.pc.in ${name}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
ljmd_pc_file(ljmd-engine "${PROJECT_DESCRIPTION}: runs in memory" ljmd_engine eigen3 "fmt gsl fftw3 libxxhash"
             "${CMAKE_THREAD_LIBS_INIT}")
if(LJMD_FILES)
    # Some builds of HDF5 bring no hdf5.pc: then its file is named.
    pkg_check_modules(ljmd_hdf5_pc QUIET hdf5)
    set(hdf5_module hdf5)
    set(hdf5_library "")
    if(NOT ljmd_hdf5_pc_FOUND)
        get_target_property(hdf5_library hdf5::hdf5 LOCATION)
        set(hdf5_module "")
    endif()
    ljmd_pc_file(ljmd "${PROJECT_DESCRIPTION}" ljmd ljmd-engine "fmt ${ljmd_toml_module} libxxhash zlib ${hdf5_module}"
                 "${hdf5_library} -l${CMAKE_DL_LIBS}")
endif()

if(NOT TARGET uninstall)
    add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D manifest=${CMAKE_BINARY_DIR}/install_manifest.txt
                                        -P ${CMAKE_CURRENT_LIST_DIR}/LjmdUninstall.cmake VERBATIM)
endif()
