# One set of compiler flags for every target of this project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
# The movie encoder lies beside the programs, or in a library folder of its own where they are installed.
set(CMAKE_BUILD_RPATH "$ORIGIN")
file(RELATIVE_PATH library_folder ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/echolucent)
set(CMAKE_INSTALL_RPATH "$ORIGIN/${library_folder}")
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# g++ looks for memory that it can give back each time its own has doubled, from 128 MB on. If it does so later, a unit of many
# files compiles in 84 to 95 % of the time and takes a quarter more memory, 1.5 GB at most. The code is the same.
add_compile_options("$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-expand=200 --param ggc-min-heapsize=500000>")

# Of -O3 this code needs two things: loops become vectors, and short ones are unrolled. So the ray caster's kernels compile in 60 %
# of the time of -O3, rooms that read files in 70 %. The kernels run as fast.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    string(REPLACE "-O3" "-O2 -ftree-vectorize -fvect-cost-model=dynamic -fpeel-loops" CMAKE_CXX_FLAGS_RELEASE
        "${CMAKE_CXX_FLAGS_RELEASE}")
endif()

# For daily work, where files are compiled one by one. A first build takes a seventh longer with it.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_UNITY_BUILD)
    # Paths below the source folder are hashed relative to it, so that two clones share one cache. Precompiled headers hit
    # only where macros and times inside them are not asked for.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# Of the linkers that come with g++, gold takes a quarter of the time for some thirty programs with VTK. It warns of each symbol
# of clang's sanitizers; clang's own linker does not.
include(CheckLinkerFlag)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(linker lld)
else()
    set(linker gold)
endif()
check_linker_flag(CXX -fuse-ld=${linker} ECHOLUCENT_HAS_LINKER)
if(ECHOLUCENT_HAS_LINKER)
    add_link_options(-fuse-ld=${linker})
endif()

# No -ffast-math anywhere: NaN voxels must stay recognisable. No contraction: the same bits on every machine.
add_library(echolucent_flags INTERFACE)
add_library(Echolucent::flags ALIAS echolucent_flags)
target_compile_options(echolucent_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
# g++ 12 warns of its own std::string where a literal and a temporary are added (its bug 105651).
target_compile_options(echolucent_flags INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict>)
target_include_directories(echolucent_flags INTERFACE ${PROJECT_SOURCE_DIR})
if(CMAKE_UNITY_BUILD)
    # g++ takes the .cpp files of a room for headers, in which a class with members of an anonymous namespace would be a fault.
    target_compile_options(echolucent_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
# Instruction sets for which no kernel is compiled. Vectors of SVE cannot be members of classes (ray_caster/packet_targets.h).
# Processors that have SSSE3 and not SSE4 are of 2006 and 2007: they run what every processor can.
set(disabled_targets "HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_SSSE3|HWY_AVX3_DL")
if(ECHOLUCENT_SANITIZE)
    # What every processor has and AVX2 stand for the others, whose kernels come from the same lines and would compile for
    # minutes; the release build tests all that the machine has.
    add_compile_definitions(ECHOLUCENT_SANITIZED)
    string(APPEND disabled_targets "|HWY_SSE4|HWY_AVX3")
    # g++ says itself which sanitizer there is.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND ECHOLUCENT_SANITIZE MATCHES "address|thread")
        string(TOUPPER __SANITIZE_${CMAKE_MATCH_0}__ macro)
        add_compile_definitions(${macro})
    endif()
    add_compile_options(-fsanitize=${ECHOLUCENT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # The address sanitizer stops where these two would. Without them a unit compiles in 88 % of the time.
    if(ECHOLUCENT_SANITIZE STREQUAL "address,undefined")
        add_compile_options(-fno-sanitize=null,object-size)
    endif()
    add_link_options(-fsanitize=${ECHOLUCENT_SANITIZE})
endif()
add_compile_definitions("HWY_DISABLED_TARGETS=(${disabled_targets})")
