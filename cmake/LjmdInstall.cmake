# What 'cmake --install' puts where: program, library, headers, the packages by which CMake and pkg-config find the
# library, decks and analysis scripts.
include(CMakePackageConfigHelpers)
set(ljmd_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ljmd)

install(TARGETS ljmd DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ljmd_library EXPORT ljmd DESTINATION ${CMAKE_INSTALL_LIBDIR})
# hdf5_handle.hpp is of use to the library and its tests alone, and would make everybody need HDF5's headers.
install(DIRECTORY include/ljmd ${PROJECT_BINARY_DIR}/generated/include/ljmd DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" PATTERN "hdf5_handle.hpp" EXCLUDE)
install(DIRECTORY inputs analysis DESTINATION ${CMAKE_INSTALL_DATADIR}/ljmd PATTERN "__pycache__" EXCLUDE)
install(FILES README.md LICENSE CITATION.cff CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(LJMD_USES_OPENMM OFF)
if(OpenMM_FOUND)
    set(LJMD_USES_OPENMM ON)
endif()
install(EXPORT ljmd NAMESPACE ljmd:: FILE ljmdTargets.cmake DESTINATION ${ljmd_package_dir})
configure_package_config_file(cmake/ljmdConfig.cmake.in ljmdConfig.cmake INSTALL_DESTINATION ${ljmd_package_dir})
write_basic_package_version_file(ljmdConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ljmdConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ljmdConfigVersion.cmake
        DESTINATION ${ljmd_package_dir})

# ljmd.pc says where things are relative to itself, so that an installed tree can be moved.
file(RELATIVE_PATH ljmd_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH ljmd_pc_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH ljmd_pc_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
string(REGEX REPLACE "/$" "" ljmd_pc_prefix ${ljmd_pc_prefix})
# Some builds of HDF5 bring no hdf5.pc: then its file is named.
pkg_check_modules(ljmd_hdf5_pc QUIET hdf5)
if(ljmd_hdf5_pc_FOUND)
    set(ljmd_pc_hdf5_module hdf5)
    set(ljmd_pc_hdf5_library "")
else()
    get_target_property(ljmd_pc_hdf5_library hdf5::hdf5 LOCATION)
    set(ljmd_pc_hdf5_module "")
endif()
set(ljmd_pc_openmm "")
if(LJMD_USES_OPENMM)
    set(ljmd_pc_openmm ${OpenMM_LIBRARY})
    install(FILES cmake/FindOpenMM.cmake DESTINATION ${ljmd_package_dir})
endif()
configure_file(cmake/ljmd.pc.in ljmd.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ljmd.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
