// Agreement with nibabel, another reader and writer of NIfTI, where python3 has it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/writers/nifti_writer.h"
#include "processing/phantom/phantom.h"
#include "python_script.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using nlohmann::json;

ToolOutcome nibabel(const std::string& arguments) { return runScript("nibabel_files.py", arguments); }

/// The voxel of the grid that was read at a voxel of the file: an axis of a left-handed grid is turned round.
Vec3 readFrom(const Study& study, Vec3 voxel) {
    if (study.turnedAxis) {
        const int axis = placeOf(*study.turnedAxis);
        const std::int64_t size = study.phases[0]->geometry().size[static_cast<std::size_t>(axis)];
        voxel[axis] = static_cast<double>(size - 1) - voxel[axis];
    }
    return voxel;
}

void expectAgreement(const std::string& name, const Study& study, const json& facts) {
    const VolumeGeometry& geometry = study.phases[0]->geometry();
    const std::size_t phases = facts.at("shape").size() == 4 ? facts.at("shape")[3].get<std::size_t>() : 1;
    ASSERT_EQ(study.phases.size(), phases) << name;
    for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_EQ(geometry.size[axis], facts.at("shape")[axis].get<std::int64_t>()) << name;
    const json& affine = facts.at("affine");
    for (const Vec3& voxel : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 4), Vec3(2, 3, 4)}) {
        Vec3 ras;
        for (std::size_t row = 0; row < 3; ++row) {
            ras[static_cast<int>(row)] = affine[row][3];
            for (std::size_t axis = 0; axis < 3; ++axis)
                ras[static_cast<int>(row)] += affine[row][axis].get<double>() * voxel[static_cast<int>(axis)];
        }
        EXPECT_LT(length(geometry.patientFromVoxel(readFrom(study, voxel)) - Vec3(-ras[0], -ras[1], ras[2])), 1e-4)
            << name;
    }
    const auto values = facts.at("values").get<std::vector<double>>();
    const std::int64_t count = geometry.voxelCount();
    const auto offsetOf = [&](std::int64_t i) {
        const auto& size = geometry.size;
        const Vec3 voxel(static_cast<double>(i % size[0]), static_cast<double>(i / size[0] % size[1]),
                         static_cast<double>(i / (size[0] * size[1])));
        const Vec3 read = readFrom(study, voxel);
        return geometry.offset(std::lround(read[0]), std::lround(read[1]), std::lround(read[2]));
    };
    for (std::size_t phase = 0; phase < phases; ++phase)
        for (std::int64_t i = 0; i < count; ++i)
            ASSERT_EQ(study.phases[phase]->storedValue(offsetOf(i)),
                      static_cast<float>(values[phase * static_cast<std::size_t>(count) + static_cast<std::size_t>(i)]))
                << name << ", voxel " << i;
}

TEST(Nibabel, ItsFilesAreReadAsItReadsThem) {
    const TemporaryFolder folder;
    const ToolOutcome written = nibabel("write " + folder.path());
    if (written.missing) GTEST_SKIP() << "python3 cannot import nibabel";
    ASSERT_EQ(written.status, 0);
    std::ifstream stream(folder.file("expected.json"));
    const json expected = json::parse(stream);
    EXPECT_GT(expected.size(), 35U);
    for (const auto& [name, facts] : expected.items()) {
        const auto study = readStudy(folder.file(name), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        expectAgreement(name, *study, facts);
    }
}

TEST(Nibabel, ReadsOurFilesAsWeReadThem) {
    const TemporaryFolder folder;
    std::vector<Study> studies;
    std::string files;
    for (const int bits : {8, 16})
        for (const char* ending : {".nii", ".nii.gz"})
            for (const double mirror : {1.0, -1.0}) {
                PhantomConfig config = defaultPhantom(PhantomScene::shapes);
                config.size = {9, 10, 11};
                config.spacing = {0.4, 0.5, 0.9};
                config.bits = bits;
                const Volume made = *makePhantom(config);
                VolumeGeometry geometry = made.geometry();
                geometry.direction = rotationX(25) * rotationZ(-40) * Mat3::diag({mirror, 1, 1});
                geometry.origin = {-31.5, 12.25, 100.125};
                const auto volume = std::make_shared<const Volume>(geometry, made.voxels());
                studies.emplace_back().phases = {volume, volume};
                const std::string file = folder.file(std::to_string(studies.size()) + ending);
                ASSERT_TRUE(writeNifti(file, studies.back().phases));
                files += " " + file;
            }
    const ToolOutcome read = nibabel("read" + files);
    if (read.missing) GTEST_SKIP() << "python3 cannot import nibabel";
    ASSERT_EQ(read.status, 0);
    const json facts = json::parse(read.output);
    ASSERT_EQ(facts.size(), studies.size());
    for (std::size_t i = 0; i < studies.size(); ++i) expectAgreement(std::to_string(i), studies[i], facts[i]);
}

}  // namespace
}  // namespace echolucent
