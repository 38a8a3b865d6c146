# Sources of a folder are compiled several at a time (a "unity build"): what they all include is parsed, and what they all
# use of templates is instantiated, once for the group. `-D LJMD_UNITY_BUILD=OFF` compiles each alone, as the preset clang
# does, so that what a source forgets to include shows.
option(LJMD_UNITY_BUILD "Compile the sources of a folder several at a time" ON)

# ljmd_compile_together(<target> <source>...), but for what these folders hold:
# - rooms with loops that have to be fast: what the compiler inlines there is to depend on no other source;
# - equations of state and tests of formats, where each source has the same names for what only it sees;
# - what is compiled as another standard of C++.
function(ljmd_compile_together target)
    if(NOT LJMD_UNITY_BUILD)
        return()
    endif()
    set(most 12)
    set(sources ${ARGN})
    list(FILTER sources EXCLUDE REGEX
         "/src/(execution|model|neighbors|forces|integrators|reference/equations)/|/tests/io/formats/|/compare/openmm/")
    set(folders "")
    foreach(source IN LISTS sources)
        get_filename_component(folder ${source} DIRECTORY)
        list(APPEND folders ${folder})
        list(APPEND "in ${folder}" ${source})
    endforeach()
    list(REMOVE_DUPLICATES folders)
    foreach(folder IN LISTS folders)
        # As few groups as there have to be, and these of equal size.
        list(LENGTH "in ${folder}" count)
        math(EXPR groups "(${count} + ${most} - 1) / ${most}")
        math(EXPR size "(${count} + ${groups} - 1) / ${groups}")
        set(number 0)
        foreach(source IN LISTS "in ${folder}")
            math(EXPR group "${number} / ${size}")
            file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${folder})
            string(REPLACE "/" "_" name "${name}_${group}")
            set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${name})
            math(EXPR number "${number} + 1")
        endforeach()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # Warnings of what only the sources of a group are to each other.
    set(before "#pragma GCC diagnostic ignored \"-Wshadow\"")
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        string(APPEND before "\n#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"")
    endif()
    set_property(TARGET ${target} PROPERTY UNITY_BUILD_CODE_BEFORE_INCLUDE "${before}")
endfunction()
