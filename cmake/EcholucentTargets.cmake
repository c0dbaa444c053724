# A library of one folder: every .h and .cpp in the given folders, compiled with the project's flags.
function(echolucent_library name)
    cmake_parse_arguments(ARG "" "" "FOLDERS;PUBLIC;PRIVATE" ${ARGN})
    set(sources)
    foreach(folder IN LISTS ARG_FOLDERS)
        file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.h ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND sources ${found})
    endforeach()
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC echolucent_flags ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# A GoogleTest program of one folder; its tests appear in CTest by name.
function(echolucent_google_test name)
    cmake_parse_arguments(ARG "" "" "LINK;ENVIRONMENT" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    echolucent_test_definitions(${name})
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()

# A Qt Test program from one source file; runs under Xvfb, on OpenGL by llvmpipe.
function(echolucent_qt_test name source)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_executable(${name} ${source})
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(${name} PRIVATE ${ARG_LINK} Qt6::Test)
    echolucent_test_definitions(${name})
    add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/scripts/with-display $<TARGET_FILE:${name}>)
    set_tests_properties(${name} PROPERTIES TIMEOUT 600)
endfunction()

function(echolucent_test_definitions name)
    target_compile_definitions(${name} PRIVATE
        ECHOLUCENT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" ECHOLUCENT_BINARY_DIR="${PROJECT_BINARY_DIR}")
endfunction()
