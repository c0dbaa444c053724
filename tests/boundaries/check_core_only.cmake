# Configures the core-only variant in a folder of its own and checks that Qt, VTK and DCMTK were never looked for.
set(forbidden)
foreach(package Qt6 Qt5 VTK DCMTK)
    list(APPEND forbidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BINARY_DIR} -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DECHOLUCENT_CORE_ONLY=ON ${forbidden} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "The core does not configure without Qt and VTK:\n${output}")
endif()
file(STRINGS ${BINARY_DIR}/CMakeCache.txt entries REGEX "^(Qt6|VTK|DCMTK)_DIR")
if(entries)
    message(FATAL_ERROR "The core-only build looked for ${entries}")
endif()
# ccache has every object of the full build; without it this is the price of the check.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY_DIR} --target echolucent_processing -j 2
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "The core does not compile alone:\n${output}")
endif()
