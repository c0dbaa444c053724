# Configures the core-only variant in a folder of its own and checks that Qt, VTK and DCMTK were never looked for, and that it
# compiles processing/ with the very commands of the full build in FULL_BUILD: what compiles there compiles here.
set(forbidden)
foreach(package Qt6 Qt5 VTK DCMTK)
    list(APPEND forbidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
# The flags, the build type and the like are the full build's.
load_cache(${FULL_BUILD} READ_WITH_PREFIX full_ CMAKE_BUILD_TYPE ECHOLUCENT_SANITIZE CMAKE_CXX_FLAGS
    CMAKE_CXX_FLAGS_RELWITHDEBINFO CMAKE_COMPILE_WARNING_AS_ERROR CMAKE_DISABLE_PRECOMPILE_HEADERS CMAKE_UNITY_BUILD)
set(same)
foreach(entry CMAKE_BUILD_TYPE ECHOLUCENT_SANITIZE CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_RELWITHDEBINFO
        CMAKE_COMPILE_WARNING_AS_ERROR CMAKE_DISABLE_PRECOMPILE_HEADERS CMAKE_UNITY_BUILD)
    list(APPEND same "-D${entry}=${full_${entry}}")
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BINARY_DIR} -G Ninja -DECHOLUCENT_CORE_ONLY=ON
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${same} ${forbidden}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "The core does not configure without Qt and VTK:\n${output}")
endif()
file(STRINGS ${BINARY_DIR}/CMakeCache.txt entries REGEX "^(Qt6|VTK|DCMTK)_DIR")
if(entries)
    message(FATAL_ERROR "The core-only build looked for ${entries}")
endif()

function(commands_of build result)
    file(STRINGS ${build}/compile_commands.json lines REGEX "\"command\":.*echolucent_processing\\.dir")
    string(REPLACE "${build}" "" lines "${lines}")
    set(${result} "${lines}" PARENT_SCOPE)
endfunction()
commands_of(${FULL_BUILD} full)
commands_of(${BINARY_DIR} alone)
if(alone STREQUAL "")
    message(FATAL_ERROR "The core-only build compiles no file of processing/")
endif()
if(NOT alone STREQUAL full)
    message(FATAL_ERROR "The core-only build compiles processing/ unlike the full one:\n${alone}\n\n${full}")
endif()
