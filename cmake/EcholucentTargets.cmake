# Libraries and test programs of this project. A folder is a room; with CMAKE_UNITY_BUILD (all presets but dev and alone) the
# .cpp files of a room are compiled as one file, so that headers are parsed once a room. Names are therefore unique within a
# room, also those in anonymous namespaces. Files with compile options of their own are compiled by themselves.

# Headers of others that most files of a target read are parsed once, if files are compiled one by one, or by clang, to which they
# are a fifth of a room's time. To g++ they are a twentieth, with Qt a sixth, with GoogleTest a fifth, and it parses them before
# anything else: MANY_ROOMS says that a target has so many that g++ gains too. Each file still includes what it uses:
# scripts/check compiles each alone.
function(echolucent_precompile name)
    cmake_parse_arguments(ARG "MANY_ROOMS" "" "" ${ARGN})
    set(headers ${ARG_UNPARSED_ARGUMENTS})
    if(headers AND (ARG_MANY_ROOMS OR NOT CMAKE_UNITY_BUILD OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU"))
        target_precompile_headers(${name} PRIVATE ${headers})
        # ccache asks for -fpch-preprocess. From precompiled headers g++ 12 forgets where its own std::string silences these
        # warnings; scripts/check sees true ones.
        target_compile_options(${name} PRIVATE
            "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>")
    endif()
endfunction()

# The files of a target in folders of this one, or those named.
function(echolucent_sources result)
    cmake_parse_arguments(ARG "" "" "FOLDERS;FILES;EXCEPT" ${ARGN})
    set(sources)
    foreach(folder IN LISTS ARG_FOLDERS)
        get_filename_component(folder ${folder} ABSOLUTE)
        file(GLOB found CONFIGURE_DEPENDS ${folder}/*.h ${folder}/*.cpp)
        list(APPEND sources ${found})
    endforeach()
    foreach(file IN LISTS ARG_FILES)
        get_filename_component(file ${file} ABSOLUTE)
        list(APPEND sources ${file})
    endforeach()
    foreach(file IN LISTS ARG_EXCEPT)
        list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    endforeach()
    set(${result} ${sources} PARENT_SCOPE)
endfunction()

# The rooms of a target, each one unit of a unity build; a room of many files is several, so that two cores share the work.
function(echolucent_rooms name)
    set(most_files_of_a_unit 20)
    get_target_property(sources ${name} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    set(rooms)
    foreach(source IN LISTS sources)
        get_filename_component(folder ${source} DIRECTORY)
        string(MAKE_C_IDENTIFIER "${folder}" room)
        list(APPEND rooms ${room})
        list(APPEND files_of_${room} ${source})
    endforeach()
    list(REMOVE_DUPLICATES rooms)
    foreach(room IN LISTS rooms)
        list(LENGTH files_of_${room} count)
        math(EXPR units "(${count} + ${most_files_of_a_unit} - 1) / ${most_files_of_a_unit}")
        math(EXPR each "(${count} + ${units} - 1) / ${units}")
        set(place 0)
        foreach(source IN LISTS files_of_${room})
            math(EXPR unit "${place} / ${each} + 1")
            math(EXPR place "${place} + 1")
            get_filename_component(folder ${source} DIRECTORY)
            file(RELATIVE_PATH folder ${CMAKE_CURRENT_SOURCE_DIR} ${folder})
            string(MAKE_C_IDENTIFIER "room_${folder}" group)
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${unit})
            # Highway compiles a kernel once for each instruction set, and a file that includes Highway says before which.
            file(STRINGS ${source} kernel REGEX "hwy/|packet_targets\\.h" LIMIT_COUNT 1)
            if(kernel)
                set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
            endif()
        endforeach()
    endforeach()
    set_target_properties(${name} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# A library Echolucent::NAME of every .h and .cpp in the given folders, or of the named files.
function(echolucent_library name)
    cmake_parse_arguments(ARG "" "" "FOLDERS;FILES;EXCEPT;PUBLIC;PRIVATE;PRECOMPILED" ${ARGN})
    echolucent_sources(sources FOLDERS ${ARG_FOLDERS} FILES ${ARG_FILES} EXCEPT ${ARG_EXCEPT})
    add_library(echolucent_${name} STATIC ${sources})
    add_library(Echolucent::${name} ALIAS echolucent_${name})
    target_link_libraries(echolucent_${name} PUBLIC echolucent_flags ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    echolucent_rooms(echolucent_${name})
    echolucent_precompile(echolucent_${name} ${ARG_PRECOMPILED})
endfunction()

# Targets, or with ROOMS these rooms of one, that read options, write words and join what others compute: what takes time is
# computed elsewhere. At -O1 they compile in 70 % of the time, and between a sanitizer's branches at -O0 in 40 %. IF_SANITIZED
# leaves the release build as it is: there they compute, and tests under a sanitizer give them little. Fuzzers give them much.
function(echolucent_little_optimised)
    cmake_parse_arguments(ARG "IF_SANITIZED" "" "ROOMS" ${ARGN})
    set(options)
    if(NOT ECHOLUCENT_FUZZ)
        list(APPEND options $<$<CONFIG:RelWithDebInfo>:-O0>)
    endif()
    if(NOT ARG_IF_SANITIZED)
        list(APPEND options $<$<CONFIG:Release>:-O1>)
    endif()
    foreach(name IN LISTS ARG_UNPARSED_ARGUMENTS)
        if(NOT ARG_ROOMS)
            target_compile_options(${name} PRIVATE ${options})
        endif()
        foreach(room IN LISTS ARG_ROOMS)
            string(MAKE_C_IDENTIFIER "room_${room}" group)
            foreach(unit RANGE 1 3)
                set(file ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/Unity/unity_${group}_${unit}_cxx.cxx)
                set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${options}" SKIP_PRECOMPILE_HEADERS ON)
            endforeach()
        endforeach()
    endforeach()
endfunction()

# Tests carry the label of their layer:
#   unit     starts no process and opens no window
#   program  starts the command line or the reader
#   window   opens windows
#   long     takes long: studies, figures of large phantoms, many more inputs; scripts/check --all runs these

# Programs that only measure or make pictures: nothing builds those of this folder but the target named.
function(echolucent_built_by target)
    get_property(programs DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
    set_target_properties(${programs} PROPERTIES EXCLUDE_FROM_ALL ON)
    if(NOT TARGET ${target})
        add_custom_target(${target})
    endif()
    add_dependencies(${target} ${programs})
    get_property(folder_tests DIRECTORY PROPERTY TESTS)
    if(folder_tests)
        set_tests_properties(${folder_tests} PROPERTIES LABELS long)
    endif()
endfunction()

# A test of CTest. COST is about its seconds: the costly begin first.
function(echolucent_test name)
    cmake_parse_arguments(ARG "" "LAYER;COST;TIMEOUT" "COMMAND;ENVIRONMENT" ${ARGN})
    if(NOT DEFINED ARG_COST)
        set(ARG_COST 1)
    endif()
    if(NOT DEFINED ARG_TIMEOUT)
        set(ARG_TIMEOUT 1200)
    endif()
    add_test(NAME ${name} COMMAND ${ARG_COMMAND})
    set_tests_properties(${name} PROPERTIES LABELS ${ARG_LAYER} TIMEOUT ${ARG_TIMEOUT} COST ${ARG_COST}
        ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()

# A program of tests, which LAYER_tests builds among others.
function(echolucent_test_program name layer)
    echolucent_rooms(${name})
    echolucent_test_flags(${name})
    if(NOT TARGET ${layer}_tests)
        add_custom_target(${layer}_tests)
    endif()
    add_dependencies(${layer}_tests ${name})
endfunction()

# A GoogleTest program of the given folders and files, run in PARTS processes: all tests, or with TESTS those that
# these patterns name. Suites whose names begin with "Long" are long, where LONG says that there are some.
function(echolucent_google_test name)
    cmake_parse_arguments(ARG "LONG" "LAYER;PARTS;COST" "FOLDERS;FILES;EXCEPT;TESTS;LINK;PRECOMPILED" ${ARGN})
    if(NOT ARG_FOLDERS AND NOT ARG_FILES)
        set(ARG_FOLDERS .)
    endif()
    echolucent_sources(sources FOLDERS ${ARG_FOLDERS} FILES ${ARG_FILES} EXCEPT ${ARG_EXCEPT})
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    echolucent_test_program(${name} ${ARG_LAYER})
    echolucent_precompile(${name} <gmock/gmock.h> <gtest/gtest.h> ${ARG_PRECOMPILED})
    if(NOT ARG_PARTS)
        set(ARG_PARTS 1)
    endif()
    list(JOIN ARG_TESTS ":" tests)
    foreach(part RANGE 1 ${ARG_PARTS})
        math(EXPR index "${part} - 1")
        echolucent_test(${name}.${part} LAYER ${ARG_LAYER} COST ${ARG_COST}
            COMMAND ${name} --gtest_brief=1 "--gtest_filter=${tests}-Long*:*/Long*"
            ENVIRONMENT GTEST_TOTAL_SHARDS=${ARG_PARTS} GTEST_SHARD_INDEX=${index})
    endforeach()
    if(ARG_LONG)
        echolucent_test(${name}.long LAYER long COST 100 TIMEOUT 3600
            COMMAND ${name} --gtest_brief=1 "--gtest_filter=Long*:*/Long*")
    endif()
endfunction()

# A program of Qt Test classes (tests/qt_program), run in PARTS processes, each of which gives every class a process of its own.
# APPLICATION is core, widgets or view; SCREEN is none, offscreen (no OpenGL there) or virtual (Xvfb, OpenGL by llvmpipe). LONG
# says that some functions take more inputs in the long run.
function(echolucent_qt_test name)
    cmake_parse_arguments(ARG "LONG" "LAYER;APPLICATION;SCREEN;PARTS;COST" "FOLDERS;FILES;EXCEPT;LINK;PRECOMPILED" ${ARGN})
    echolucent_sources(sources FOLDERS ${ARG_FOLDERS} FILES ${ARG_FILES} EXCEPT ${ARG_EXCEPT})
    set(frame ${PROJECT_SOURCE_DIR}/tests/qt_program)
    list(APPEND sources ${frame}/test_classes.h ${frame}/main.cpp ${frame}/${ARG_APPLICATION}_application.cpp)
    if(NOT ARG_APPLICATION STREQUAL core)
        list(APPEND sources ${frame}/picture_of_failure.cpp)
    endif()
    add_executable(${name} ${sources})
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(${name} PRIVATE ${ARG_LINK} Qt6::Test)
    echolucent_test_program(${name} ${ARG_LAYER})
    echolucent_precompile(${name} <QTest> <memory> <opencv2/core/matx.hpp> <string> <vector> ${ARG_PRECOMPILED})
    set(command ${name})
    set(environment)
    if(ARG_SCREEN STREQUAL virtual)
        set(command ${PROJECT_SOURCE_DIR}/scripts/with-display $<TARGET_FILE:${name}>)
    elseif(ARG_SCREEN STREQUAL offscreen)
        set(environment QT_QPA_PLATFORM=offscreen)
    endif()
    if(ARG_LAYER STREQUAL long)
        list(APPEND environment QTEST_FUNCTION_TIMEOUT=3000000)
    endif()
    if(NOT ARG_PARTS)
        set(ARG_PARTS 1)
    endif()
    foreach(part RANGE 1 ${ARG_PARTS})
        echolucent_test(${name}.${part} LAYER ${ARG_LAYER} COST ${ARG_COST} ENVIRONMENT ${environment}
            COMMAND ${command} --part ${part}/${ARG_PARTS})
    endforeach()
    if(ARG_LONG)
        echolucent_test(${name}.long LAYER long COST 100 TIMEOUT 3600
            COMMAND ${command} --long ENVIRONMENT ${environment} QTEST_FUNCTION_TIMEOUT=3000000)
    endif()
endfunction()

# Tests whose own code the address sanitizer does not watch: what they test is a program, which it watches in a process of its own,
# or the numeric core, whose optimised code holds its own copies of what is inline. Those of the command line compile in
# half the time. The thread sanitizer watches them: their threads meet those of the core.
function(echolucent_not_sanitized name)
    if(ECHOLUCENT_SANITIZE MATCHES "address")
        target_compile_options(${name} PRIVATE -fno-sanitize=all)
    endif()
endfunction()

# What is tested is optimised as people run it, if no sanitizer watches. The tests' own code is not: at -O0 it compiles in 55 to 80 %
# of the time of -O1, and between a sanitizer's branches in half. Fuzzers run it much.
function(echolucent_test_flags name)
    target_compile_definitions(${name} PRIVATE ECHOLUCENT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    if(NOT ECHOLUCENT_FUZZ)
        target_compile_options(${name} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O0>)
    endif()
endfunction()
