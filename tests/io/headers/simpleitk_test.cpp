// Agreement with SimpleITK on MetaImage and NIfTI, where python3 has it. Debian 12 has no package of it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "processing/phantom/phantom.h"
#include "python_script.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

TEST(SimpleItk, ReadsOurFilesAsWeReadThem) {
    const TemporaryFolder folder;
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {9, 10, 11};
    config.spacing = {0.4, 0.5, 0.9};
    config.bits = 16;
    const Volume made = *makePhantom(config);
    VolumeGeometry geometry = made.geometry();
    geometry.direction = rotationX(25) * rotationZ(-40);
    geometry.origin = {-31.5, 12.25, 100.125};
    const auto volume = std::make_shared<const Volume>(geometry, made.voxels());
    ASSERT_TRUE(writeMetaImage(folder.file("a.mha"), {volume}));
    ASSERT_TRUE(writeNifti(folder.file("a.nii.gz"), {volume}));
    const ToolOutcome outcome = runScript("simpleitk_files.py", folder.file("a.mha") + " " + folder.file("a.nii.gz"));
    if (outcome.missing) GTEST_SKIP() << "python3 cannot import SimpleITK";
    ASSERT_EQ(outcome.status, 0);
    const auto read = nlohmann::json::parse(outcome.output);
    ASSERT_EQ(read.size(), 2U);
    for (const auto& facts : read) {
        const auto values = facts.at("values").get<std::vector<double>>();
        ASSERT_EQ(values.size(), 990U);
        for (std::size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(volume->storedValue(static_cast<std::int64_t>(i)), values[i]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int row = static_cast<int>(axis);
            EXPECT_EQ(facts.at("size")[axis], geometry.size[axis]);
            EXPECT_NEAR(facts.at("spacing")[axis], geometry.spacing[row], 1e-6);
            EXPECT_NEAR(facts.at("origin")[axis], geometry.origin[row], 1e-4);
            for (std::size_t column = 0; column < 3; ++column)
                EXPECT_NEAR(facts.at("direction")[3 * axis + column], geometry.direction(row, static_cast<int>(column)),
                            1e-5);
        }
    }
}

}  // namespace
}  // namespace echolucent
