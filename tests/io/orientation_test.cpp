// One volume with marked corners, stored in every orientation and container: the markers lie at the same places, and
// the grid that is read is right-handed, so that no picture of it is a mirror image.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "io/writers/enhanced_us_writer.h"
#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

constexpr std::array<std::int64_t, 3> markedSize{3, 4, 5};

/// Corner i holds i + 1, all other voxels 0.
std::vector<std::uint8_t> markedCorners() {
    std::vector<std::uint8_t> voxels(60, 0);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t x = corner & 1 ? 2 : 0, y = corner & 2 ? 3 : 0, z = corner & 4 ? 4 : 0;
        voxels[x + 3 * (y + 4 * z)] = static_cast<std::uint8_t>(corner + 1);
    }
    return voxels;
}

/// Where the markers lie in voxels.
std::map<int, Vec3> markedVoxels(const Volume& volume) {
    std::map<int, Vec3> markers;
    const VolumeGeometry& geometry = volume.geometry();
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                if (const double value = volume.storedValue(geometry.offset(x, y, z)); value > 0)
                    markers[static_cast<int>(value)] = {static_cast<double>(x), static_cast<double>(y),
                                                        static_cast<double>(z)};
    return markers;
}

/// Where the markers lie in the patient (LPS, mm).
std::map<int, Vec3> markersIn(const Volume& volume) {
    std::map<int, Vec3> markers = markedVoxels(volume);
    for (auto& [marker, place] : markers) place = volume.geometry().patientFromVoxel(place);
    return markers;
}

/// Above 0 if the three ways from marker 1 to its neighbours lie like the thumb and the next two fingers of the right
/// hand.
double handOf(const std::map<int, Vec3>& markers) {
    const Vec3& from = markers.at(1);
    return (markers.at(2) - from).cross(markers.at(3) - from).dot(markers.at(5) - from);
}

/// `statesHands`: whether the format can hold a left-handed grid.
void expectSameMarkers(const std::string& file, const Volume& truth, const std::string& what, double mm = 1e-5,
                       bool statesHands = true) {
    const auto study = readStudy(file, withoutGuess());
    ASSERT_TRUE(study) << what << ": " << study.error().sentence();
    const auto expected = markersIn(truth), found = markersIn(*study->phases[0]);
    ASSERT_EQ(found.size(), 8U) << what;
    for (const auto& [marker, place] : expected)
        EXPECT_LT(length(found.at(marker) - place), mm) << what << ", marker " << marker;
    EXPECT_LT(length(study->phases[0]->geometry().spacing - truth.geometry().spacing), 1e-6) << what;
    // Pictures show grid mm as they show a patient: right-handed.
    EXPECT_GT(handOf(markedVoxels(*study->phases[0])) * handOf(expected), 0.0) << what << ": a mirror image";
    const bool isLeftHanded = statesHands && cv::determinant(truth.geometry().direction) < 0;
    EXPECT_EQ(study->turnedAxis.has_value(), isLeftHanded) << what;
}

/// The three axes in every order and sign, and some that are oblique; half of them are mirrored.
std::vector<Mat3> orientations() {
    std::vector<Mat3> all;
    for (const std::array<int, 3>& order : {std::array{0, 1, 2}, std::array{0, 2, 1}, std::array{1, 0, 2},
                                            std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{2, 1, 0}})
        for (int signs = 0; signs < 8; ++signs) {
            Mat3 direction = Mat3::zeros();
            for (int axis = 0; axis < 3; ++axis)
                direction(order[static_cast<std::size_t>(axis)], axis) = (signs >> axis & 1) != 0 ? -1 : 1;
            all.push_back(direction);
        }
    for (const double degrees : {17.0, -100.0, 179.0})
        for (const double mirror : {1.0, -1.0})
            all.push_back(rotationX(degrees) * rotationY(0.4 * degrees) * rotationZ(-1.3 * degrees) *
                          Mat3::diag({1, mirror, 1}));
    return all;
}

std::string nrrdOf(const Volume& volume, const std::string& space, const Vec3& sign) {
    const VolumeGeometry& geometry = volume.geometry();
    std::string text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 4 5\nencoding: raw\nspace: " + space;
    text += "\nspace directions:";
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step =
            Vec3(geometry.direction(0, axis), geometry.direction(1, axis), geometry.direction(2, axis)).mul(sign) *
            geometry.spacing[axis];
        text += fmt::format(" ({},{},{})", step[0], step[1], step[2]);
    }
    const Vec3 origin = geometry.origin.mul(sign);
    text += fmt::format("\nspace origin: ({},{},{})\n\n", origin[0], origin[1], origin[2]);
    const auto& voxels = std::get<VoxelArray<std::uint8_t>>(volume.voxels());
    return text + std::string(voxels.begin(), voxels.end());
}

std::string bytesOfFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Orientation, IsTheSameInEveryContainer) {
    const TemporaryFolder folder;
    for (const Mat3& direction : orientations()) {
        VolumeGeometry geometry;
        geometry.size = markedSize;
        geometry.spacing = {0.5, 0.75, 1.25};
        geometry.origin = {-12, 34, 5.5};
        geometry.direction = direction;
        const auto truth = std::make_shared<const Volume>(geometry, markedCorners());

        ASSERT_TRUE(writeMetaImage(folder.file("v.mha"), {truth}));
        expectSameMarkers(folder.file("v.mha"), *truth, "MetaImage");
        expectSameMarkers(folder.write("l.nrrd", nrrdOf(*truth, "LPS", {1, 1, 1})), *truth, "LPS");
        expectSameMarkers(folder.write("r.nrrd", nrrdOf(*truth, "RAS", {-1, -1, 1})), *truth, "RAS");
        expectSameMarkers(folder.write("a.nrrd", nrrdOf(*truth, "LAS", {1, -1, 1})), *truth, "LAS");

        ASSERT_TRUE(writeNifti(folder.file("both.nii"), {truth}));
        expectSameMarkers(folder.file("both.nii"), *truth, "both forms");
        std::string bytes = bytesOfFile(folder.file("both.nii"));
        bytes[254] = 0;                                                              // sform_code
        expectSameMarkers(folder.write("qform.nii", bytes), *truth, "qform", 2e-3);  // float32 of a quaternion
        bytes[254] = 1;
        bytes[252] = 0;  // qform_code
        expectSameMarkers(folder.write("sform.nii", bytes), *truth, "sform");
        EXPECT_TRUE(readStudy(folder.file("both.nii"))->warnings.empty());

        ASSERT_TRUE(writeEnhancedUs(folder.file("us.dcm"), {truth}, {}));
        expectSameMarkers(folder.file("us.dcm"), *truth, "Enhanced US Volume", 1e-5, false);
    }
}

TEST(Orientation, OfTwoNiftiFormsTheSformCountsAndTheOtherIsSaid) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = markedSize;
    geometry.direction = rotationZ(30);
    const auto truth = std::make_shared<const Volume>(geometry, markedCorners());
    ASSERT_TRUE(writeNifti(folder.file("v.nii"), {truth}));
    std::string bytes = bytesOfFile(folder.file("v.nii"));
    const float elsewhere = 25.0F;
    bytes.replace(268, 4, std::string(reinterpret_cast<const char*>(&elsewhere), 4));  // qoffset_x
    const auto study = readStudy(folder.write("two.nii", bytes), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, "up to 25 mm apart; sform counts"));
    EXPECT_LT(length(study->phases[0]->geometry().origin - geometry.origin), 1e-6);
    EXPECT_EQ(factOf(*study, "patient frame"), "scanner, RAS turned into LPS");
    bytes.replace(280, 48, std::string(48, '\0'));  // an sform that is none
    const auto other = readStudy(folder.write("other.nii", bytes), withoutGuess());
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_TRUE(warnsOf(*other, "sform is ignored"));
    EXPECT_LT(length(other->phases[0]->geometry().origin - Vec3(-25, 0, 0)), 1e-6);
}

TEST(Orientation, ThePatientsFrameIsKnownAsForOtherContainers) {
    const TemporaryFolder folder;
    const auto isKnown = [&](const Mat3& direction) {
        VolumeGeometry geometry;
        geometry.size = markedSize;
        geometry.direction = direction;
        EXPECT_TRUE(writeNifti(folder.file("v.nii"), {std::make_shared<const Volume>(geometry, markedCorners())}));
        return readStudy(folder.file("v.nii"))->phases[0]->geometry().patientFrameKnown;
    };
    EXPECT_FALSE(isKnown(Mat3::eye()));
    EXPECT_FALSE(isKnown(Mat3::diag({-1, -1, 1})));
    EXPECT_TRUE(isKnown(Mat3::diag({-1, 1, 1})));
    EXPECT_TRUE(isKnown(rotationX(20)));
}

}  // namespace
}  // namespace echolucent
