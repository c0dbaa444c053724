// Real files beside the source tree.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace echolucent {

/// Their folder.
inline const std::string sharedData = ECHOLUCENT_SOURCE_DIR "/../shared/data";

}  // namespace echolucent

/// Skips a test if these files are missing.
#define SKIP_WITHOUT_SHARED_DATA()                              \
    if (!std::filesystem::is_directory(echolucent::sharedData)) \
    GTEST_SKIP() << "the shared data are not here: " << echolucent::sharedData
