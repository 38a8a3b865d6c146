# The engine in a page: the rooms from core to engine, decks, and readers and writers of text, with src/page as the door to
# the page's script. Emscripten's files are in memory. What needs HDF5, zlib or other processes is left out.
ljmd_sources_of(ljmd_page_files io input deck run)
list(FILTER ljmd_page_files EXCLUDE REGEX
     "/(hdf5/.*|[^/]*h5md[^/]*|body_trajectory|gzip_input|process|program_module|scratch_directory|[^/]*interruption)\\.cpp$")
file(GLOB ljmd_page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/page/*.cpp)
list(FILTER ljmd_page_sources EXCLUDE REGEX /fourier.cpp$)
add_library(ljmd_page_files STATIC ${ljmd_page_files} ${ljmd_file_registries})
ljmd_compile_together(ljmd_page_files ${ljmd_page_files})
add_executable(ljmd_page ${ljmd_page_sources})
foreach(target ljmd_page_files ljmd_page)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} PRIVATE ${ljmd_version_include})
    target_link_libraries(${target} PRIVATE ljmd_engine ljmd_options fmt::fmt nlohmann_json::nlohmann_json
                                            PkgConfig::tomlplusplus PkgConfig::xxhash)
endforeach()
target_link_libraries(ljmd_page PRIVATE ljmd_page_files)
# A module that is given its WebAssembly by the page; without one, by the file beside it.
target_link_options(ljmd_page PRIVATE -sMODULARIZE -sEXPORT_NAME=ljmdEngine -sENVIRONMENT=web,worker,node
    -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=32MB -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=1MB -sNO_EXIT_RUNTIME
    -sEXPORTED_FUNCTIONS=_malloc,_free -sEXPORTED_RUNTIME_METHODS=lengthBytesUTF8,stringToUTF8,UTF8ToString,HEAPU8,HEAPU16 --no-entry)
