// Left-handed grids: those of one axis that runs backwards become what they would be without that fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include <fmt/format.h>

#include "dicom_files.h"
#include "io/stored/right_handed.h"
#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "kretz_files.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

constexpr std::array allGridAxes{GridAxis::x, GridAxis::y, GridAxis::z};
using Size = std::array<std::int64_t, 3>;
const Mat3 axesOfRas = Mat3::diag({-1, -1, 1});

VolumeGeometry placed(const Size& size, const Mat3& direction = Mat3::eye()) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = {0.5, 0.75, 1.25};
    geometry.origin = {-12, 34, 5.5};
    geometry.direction = direction;
    return geometry;
}

/// The grid of the same places that begins at the other end of an axis, and is therefore of the other hand.
VolumeGeometry backwards(VolumeGeometry geometry, GridAxis axis) {
    const int of = placeOf(axis);
    Vec3 last(0, 0, 0);
    last[of] = static_cast<double>(geometry.size[static_cast<std::size_t>(of)] - 1);
    geometry.origin = geometry.patientFromVoxel(last);
    for (int row = 0; row < 3; ++row) geometry.direction(row, of) *= -1;
    return geometry;
}

/// The values of one phase, each of `width` bytes, in the order of the grid that runs backwards along an axis.
std::string backwards(const std::string& values, const Size& size, std::size_t width, GridAxis axis) {
    std::string turned(values.size(), '\0');
    const auto of = static_cast<std::size_t>(placeOf(axis));
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                Size to{x, y, z};
                to[of] = size[of] - 1 - to[of];
                const auto offset = [&](const Size& at) {
                    return static_cast<std::size_t>(at[0] + size[0] * (at[1] + size[1] * at[2])) * width;
                };
                turned.replace(offset(to), width, values.substr(offset({x, y, z}), width));
            }
    return turned;
}

std::string randomValues(const Size& size, std::size_t width) {
    std::mt19937 random(11);
    std::string values(static_cast<std::size_t>(size[0] * size[1] * size[2]) * width, '\0');
    for (char& byte : values) byte = static_cast<char>(random() % 100);
    return values;
}

/// A NRRD of one phase, or with the words of an axis of phases before or behind those of the space axes.
struct Nrrd {
    std::string type = "uchar", space = "LPS", sizes = "3 4 5", kinds = "domain domain domain";
    std::array<std::string, 2> phases{};
    Vec3 sign{1, 1, 1};  ///< what turns LPS into the frame
};

std::string nrrdOf(const Nrrd& nrrd, const VolumeGeometry& geometry, const std::string& bytes) {
    const auto vector = [&](const Vec3& lps) {
        const Vec3 own = lps.mul(nrrd.sign);
        return fmt::format(" ({},{},{})", own[0], own[1], own[2]);
    };
    std::string text =
        "NRRD0005\ntype: " + nrrd.type + "\ndimension: " + (nrrd.phases[0] + nrrd.phases[1] == "" ? "3" : "4");
    text +=
        "\nsizes: " + nrrd.sizes + "\nkinds: " + nrrd.kinds + "\nendian: little\nencoding: raw\nspace: " + nrrd.space;
    text += "\nspace directions:" + nrrd.phases[0];
    for (int axis = 0; axis < 3; ++axis)
        text += vector(Vec3(geometry.direction.col(axis).val) * geometry.spacing[axis]);
    return text + nrrd.phases[1] + "\nspace origin:" + vector(geometry.origin) + "\n\n" + bytes;
}

Volume volumeOf(const VolumeGeometry& geometry, const std::string& bytes) {
    return Volume(geometry, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

/// Whether the file of a left-handed grid opens as its twin, the file without the fault.
void expectTwin(const std::string& left, const std::string& right, GridAxis turned, const std::string& what,
                const ReadOptions& options = withoutGuess()) {
    const auto study = readStudy(left, options), twin = readStudy(right, options);
    ASSERT_TRUE(study) << what << ": " << study.error().sentence();
    ASSERT_TRUE(twin) << what << ": " << twin.error().sentence();
    ASSERT_EQ(study->phases.size(), twin->phases.size()) << what;
    for (std::size_t phase = 0; phase < study->phases.size(); ++phase) {
        EXPECT_TRUE(study->phases[phase]->voxels() == twin->phases[phase]->voxels()) << what << ", phase " << phase;
        const VolumeGeometry &geometry = study->phases[phase]->geometry(), &of = twin->phases[phase]->geometry();
        EXPECT_EQ(geometry.size, of.size) << what;
        EXPECT_EQ(geometry.spacing, of.spacing) << what;
        EXPECT_EQ(geometry.reduction, of.reduction) << what;
        EXPECT_LT(cv::norm(geometry.direction - of.direction), 1e-6) << what;
        EXPECT_LT(length(geometry.origin - of.origin), 1e-5) << what;
    }
    EXPECT_EQ(study->turnedAxis, turned) << what;
    EXPECT_EQ(factOf(*study, "handedness"),
              "left-handed grid: its " + std::string(nameOf(turned)) + " axis is turned round")
        << what;
    EXPECT_EQ(twin->turnedAxis, std::nullopt) << what;
}

TEST(LeftHandedGrid, OfOneAxisThatRunsBackwardsInTheFilesFrameBecomesItsTwin) {
    const TemporaryFolder folder;
    const Size size{3, 4, 5};
    const std::string values = randomValues(size, 1);
    for (const GridAxis axis : allGridAxes) {
        const std::string turned = backwards(values, size, 1, axis), name(nameOf(axis));
        const VolumeGeometry lps = placed(size), ras = placed(size, axesOfRas);
        const auto left = [&](const VolumeGeometry& of) { return backwards(of, axis); };
        const auto shared = [](const Volume& volume) { return std::make_shared<const Volume>(volume); };
        for (const Nrrd& nrrd : {Nrrd{}, Nrrd{.space = "left-posterior-superior"}, Nrrd{.space = "3D-right-handed"},
                                 Nrrd{.space = "scanner-xyz"}})
            expectTwin(folder.write("l.nrrd", nrrdOf(nrrd, left(lps), turned)),
                       folder.write("r.nrrd", nrrdOf(nrrd, lps, values)), axis, nrrd.space + " " + name);
        const Nrrd inRas{.space = "RAS", .sign = {-1, -1, 1}};
        expectTwin(folder.write("l.nrrd", nrrdOf(inRas, left(ras), turned)),
                   folder.write("r.nrrd", nrrdOf(inRas, ras, values)), axis, "RAS " + name);
        ASSERT_TRUE(writeMetaImage(folder.file("l.mha"), {shared(volumeOf(left(lps), turned))}));
        ASSERT_TRUE(writeMetaImage(folder.file("r.mha"), {shared(volumeOf(lps, values))}));
        expectTwin(folder.file("l.mha"), folder.file("r.mha"), axis, "MetaImage " + name);
        ASSERT_TRUE(writeNifti(folder.file("l.nii"), {shared(volumeOf(left(ras), turned))}));
        ASSERT_TRUE(writeNifti(folder.file("r.nii"), {shared(volumeOf(ras, values))}));
        expectTwin(folder.file("l.nii"), folder.file("r.nii"), axis, "NIfTI " + name);
        std::string qform = contentsOf(folder.file("l.nii"));
        qform[254] = 0;  // sform_code
        expectTwin(folder.write("q.nii", qform), folder.file("r.nii"), axis, "qform " + name);
    }
}

TEST(LeftHandedGrid, IsTurnedInEveryTypeColourAndPhase) {
    const TemporaryFolder folder;
    const Size size{3, 4, 5};
    for (const GridAxis axis : allGridAxes) {
        const VolumeGeometry right = placed(size), left = backwards(right, axis);
        for (const auto& [type, width] : {std::pair<const char*, std::size_t>{"int8", 1},
                                          {"uint16", 2},
                                          {"int16", 2},
                                          {"uint32", 4},
                                          {"int64", 8}}) {
            const std::string values = randomValues(size, width);
            const Nrrd nrrd{.type = type};
            expectTwin(folder.write("l.nrrd", nrrdOf(nrrd, left, backwards(values, size, width, axis))),
                       folder.write("r.nrrd", nrrdOf(nrrd, right, values)), axis, type);
        }
        const std::string one = randomValues(size, 1), two(one.rbegin(), one.rend());
        const std::string oneTurned = backwards(one, size, 1, axis), twoTurned = backwards(two, size, 1, axis);
        const Nrrd after{.sizes = "3 4 5 2", .kinds = "domain domain domain time", .phases = {"", " none"}};
        expectTwin(folder.write("l.nrrd", nrrdOf(after, left, oneTurned + twoTurned)),
                   folder.write("r.nrrd", nrrdOf(after, right, one + two)), axis, "phases one after the other");
        const auto interleaved = [](const std::string& first, const std::string& second) {
            std::string both;
            for (std::size_t i = 0; i < first.size(); ++i) both += {first[i], second[i]};
            return both;
        };
        const Nrrd before{.sizes = "2 3 4 5", .kinds = "time domain domain domain", .phases = {" none", ""}};
        expectTwin(folder.write("l.nrrd", nrrdOf(before, left, interleaved(oneTurned, twoTurned))),
                   folder.write("r.nrrd", nrrdOf(before, right, interleaved(one, two))), axis, "phases interleaved");
        const std::string colours = randomValues(size, 3);
        const Nrrd colour{.sizes = "3 3 4 5", .kinds = "RGB-color domain domain domain", .phases = {" none", ""}};
        expectTwin(folder.write("l.nrrd", nrrdOf(colour, left, backwards(colours, size, 3, axis))),
                   folder.write("r.nrrd", nrrdOf(colour, right, colours)), axis, "colour");
    }
}

TEST(LeftHandedGrid, OfALeftHandedFrameIsItsMirrorImage) {
    const TemporaryFolder folder;
    const Size size{3, 4, 5};
    const std::string values = randomValues(size, 1);
    const VolumeGeometry right = placed(size);
    const std::string twin = folder.write("r.nrrd", nrrdOf({}, right, values));
    // In LAS, the axes of the frame themselves are a left-handed grid: y runs against P.
    const Nrrd las{.space = "left-anterior-superior", .sign = {1, -1, 1}};
    expectTwin(
        folder.write("l.nrrd", nrrdOf(las, backwards(right, GridAxis::y), backwards(values, size, 1, GridAxis::y))),
        twin, GridAxis::y, "LAS");
    for (const char* space : {"3D-left-handed", "3d-left-handed-time"}) {
        const Nrrd frame{.space = space, .sign = {1, 1, -1}};
        expectTwin(folder.write("l.nrrd",
                                nrrdOf(frame, backwards(right, GridAxis::z), backwards(values, size, 1, GridAxis::z))),
                   twin, GridAxis::z, space);
        const auto other = readStudy(folder.write("o.nrrd", nrrdOf(frame, right, values)), withoutGuess());
        ASSERT_TRUE(other) << other.error().sentence();
        EXPECT_EQ(other->turnedAxis, std::nullopt) << "a left-handed grid in a left-handed frame is right-handed";
        EXPECT_TRUE(other->phases[0]->voxels() == readStudy(twin, withoutGuess())->phases[0]->voxels());
        EXPECT_FALSE(other->phases[0]->geometry().patientFrameKnown);
    }
}

TEST(LeftHandedGrid, OfFramesOverTimeIsNone) {
    const TemporaryFolder folder;
    // Two directions in a left-handed frame, and frames in place of the third.
    const std::string header =
        "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 3 4 5\nkinds: domain domain list\nencoding: raw\nspace: LAS\n"
        "space directions: (1,0,0) (0,1,0) none\n\n";
    const std::string values = randomValues({3, 4, 5}, 1);
    const auto study = readStudy(folder.write("list.nrrd", header + values), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->turnedAxis, std::nullopt);
    EXPECT_EQ(study->phases[0]->storedValue(0), values[0]);
}

TEST(LeftHandedGrid, OfANegativeSpacingBecomesItsTwin) {
    const TemporaryFolder folder;
    const Size size{3, 4, 5};
    const std::string values = randomValues(size, 1);
    const std::array<std::string, 3> spacings{"-1 1 1", "1 -1 1", "1 1 -1"};
    for (const GridAxis axis : allGridAxes) {
        const auto of = static_cast<std::size_t>(placeOf(axis));
        const std::string turned = backwards(values, size, 1, axis);
        Vec3 origin(0, 0, 0);
        origin[placeOf(axis)] = static_cast<double>(size[of] - 1);
        const auto metaImage = [](const std::string& spacing, const Vec3& offset) {
            return fmt::format(
                "ObjectType = Image\nNDims = 3\nDimSize = 3 4 5\nElementSpacing = {}\nOffset = {} {} {}\n"
                "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
                spacing, offset[0], offset[1], offset[2]);
        };
        expectTwin(folder.write("l.mha", metaImage(spacings[of], origin) + turned),
                   folder.write("r.mha", metaImage("1 1 1", {0, 0, 0}) + values), axis, "ElementSpacing");
        const auto nrrd = [](const std::string& spacing, const Vec3& at) {
            return fmt::format(
                "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 3 4 5\nspacings: {}\nencoding: raw\n"
                "space origin: ({},{},{})\n\n",
                spacing, at[0], at[1], at[2]);
        };
        expectTwin(folder.write("l.nrrd", nrrd(spacings[of], origin) + turned),
                   folder.write("r.nrrd", nrrd("1 1 1", {0, 0, 0}) + values), axis, "spacings");
    }
}

/// The voxels of a study, and that no axis was turned round.
Voxels untouchedVoxels(const Result<Study>& study) {
    EXPECT_TRUE(study) << study.error().sentence();
    if (!study) return {};
    EXPECT_EQ(study->turnedAxis, std::nullopt);
    EXPECT_GT(cv::determinant(study->phases[0]->geometry().direction), 0.0);
    return study->phases[0]->voxels();
}

TEST(LeftHandedGrid, IsNoneOfDicomSlicesInWhateverOrder) {
    for (const Mat3& direction : {Mat3::eye(), rotationX(20) * rotationZ(130)}) {
        const Size size{3, 4, 5};
        const VolumeGeometry right = placed(size, direction);
        const std::string values = randomValues(size, 1);
        const TemporaryFolder rising, falling;
        for (int slice = 0; slice < 5; ++slice) {
            TestImage image;
            image.columns = 3;
            image.rows = 4;
            image.instance = slice + 1;
            image.pixelSpacing = std::array{0.75, 0.5};
            image.orientation = std::array{direction(0, 0), direction(1, 0), direction(2, 0),
                                           direction(0, 1), direction(1, 1), direction(2, 1)};
            const auto write = [&](const TemporaryFolder& folder, int place) {
                image.position = right.patientFromVoxel({0, 0, static_cast<double>(place)});
                image.pixels8.assign(values.begin() + place * 12, values.begin() + (place + 1) * 12);
                writeDicom(folder.file(fmt::format("{}.dcm", slice)), image);
            };
            write(rising, slice);
            write(falling, 4 - slice);
        }
        const auto study = readStudy(falling.path(), withoutGuess());
        EXPECT_TRUE(untouchedVoxels(study) == untouchedVoxels(readStudy(rising.path(), withoutGuess())));
        EXPECT_TRUE(untouchedVoxels(study) == volumeOf(right, values).voxels());
        EXPECT_LT(length(study->phases[0]->geometry().origin - right.origin), 1e-5);
    }
}

TEST(LeftHandedGrid, IsNoneOfBeamsThatAreCountedTheOtherWay) {
    const TemporaryFolder folder;
    const Size size{12, 7, 5};
    const std::string values = randomValues(size, 1);
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler})
        for (const GridAxis axis : {GridAxis::y, GridAxis::z}) {
            ReadOptions options = withoutGuess();
            options.raw = RawLayout{};
            options.raw->size = size;
            options.raw->polar = polarGeometry({kind, 1, 0.5, {-20, 25}, {-15, 10}, 30, 20}, size);
            const auto rising = readStudy(folder.write("rising.raw", values), options);
            PolarAxis& counted = axis == GridAxis::y ? options.raw->polar->lines : options.raw->polar->planes;
            std::ranges::reverse(counted.values);
            const auto falling = readStudy(folder.write("falling.raw", backwards(values, size, 1, axis)), options);
            EXPECT_TRUE(untouchedVoxels(rising) == untouchedVoxels(falling)) << nameOf(kind) << ' ' << nameOf(axis);
        }
    KretzParts parts;
    const Size kretzSamples{20, 5, 4};
    const std::string echo = randomValues(kretzSamples, 1);
    parts.voxels = kretzItem(0xD000, 1, echo);
    const auto rising = readStudy(folder.write("rising.vol", parts.bytes()), withoutGuess());
    parts.planeAngles = kretzNumbers(0xC300, 1, {1.7, 1.6, 1.5, 1.4});
    parts.voxels = kretzItem(0xD000, 1, backwards(echo, kretzSamples, 1, GridAxis::z));
    const auto falling = readStudy(folder.write("falling.vol", parts.bytes()), withoutGuess());
    EXPECT_TRUE(untouchedVoxels(rising) == untouchedVoxels(falling));
}

TEST(LeftHandedGrid, WithoutAnAxisThatRunsBackwardsIsTurnedAlongZ) {
    StoredVolume stored;
    stored.geometry = placed({3, 4, 5}, {0, 1, 0, 1, 0, 0, 0, 0, 1});  // rows and columns have changed places
    EXPECT_EQ(axisToTurn(stored), GridAxis::z);
    stored.geometry.direction = {0, -1, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_EQ(axisToTurn(stored), std::nullopt);
    stored.geometry.direction = rotationX(17) * rotationY(-11) * Mat3::diag({1, -1, 1});
    EXPECT_EQ(axisToTurn(stored), GridAxis::y);
    // Of several that run backwards alike, rounding does not choose.
    for (const double rounding : {-1e-7, 0.0, 1e-7}) {
        stored.geometry.direction = Mat3::diag({-1 + rounding, -1, -1 - rounding});
        EXPECT_EQ(axisToTurn(stored), GridAxis::z);
    }
}

TEST(LeftHandedGrid, OfAnotherOrderOfAxesKeepsItsPlaces) {
    VolumeGeometry geometry = placed({3, 4, 5}, rotationX(20) * rotationZ(130) * Mat3::diag({1, 1, -1}));
    geometry.probe = StatedProbe{{0.6, 0, 0.8}, {0, -1, 0}, Vec3(1, 2, 3)};
    for (const GridAxis axis : allGridAxes) {
        const VolumeGeometry turned = turnedRound(geometry, axis);
        EXPECT_LT(cv::norm(turned.direction - backwards(geometry, axis).direction), 1e-12);
        EXPECT_LT(length(turned.origin - backwards(geometry, axis).origin), 1e-12);
        const auto inPatient = [](const VolumeGeometry& of, const Vec3& mm) { return of.origin + of.direction * mm; };
        EXPECT_LT(length(inPatient(turned, *turned.probe->apexMm) - inPatient(geometry, *geometry.probe->apexMm)),
                  1e-12);
        EXPECT_LT(length(turned.direction * turned.probe->forward - geometry.direction * geometry.probe->forward),
                  1e-12);
        EXPECT_LT(length(turned.direction * turned.probe->down - geometry.direction * geometry.probe->down), 1e-12);
    }
}

TEST(LeftHandedGrid, ThatIsReducedIsReducedAsItsTwin) {
    const TemporaryFolder folder;
    const Size size{131, 103, 89};  // no multiple of any factor
    ReadOptions options = withoutGuess();
    options.studyMebibytes = 1;
    const std::string values = randomValues(size, 1);
    for (const GridAxis axis : allGridAxes) {
        const VolumeGeometry right = placed(size);
        const Nrrd nrrd{.sizes = "131 103 89"};
        expectTwin(folder.write("l.nrrd", nrrdOf(nrrd, backwards(right, axis), backwards(values, size, 1, axis))),
                   folder.write("r.nrrd", nrrdOf(nrrd, right, values)), axis, std::string(nameOf(axis)), options);
        EXPECT_TRUE(readStudy(folder.file("l.nrrd"), options)->phases[0]->geometry().reduction);
    }
}

TEST(LeftHandedGrid, HasTheCoarseGridOfItsTwin) {
    for (const GridAxis axis : allGridAxes) {
        const VolumeGeometry twin = placed({351, 322, 316}), stored = backwards(twin, axis);
        const CoarseGrid grid = *coarseGridOf(twin), same = asStored(grid, stored, axis);
        EXPECT_EQ(same.full.direction, stored.direction);
        const auto of = static_cast<std::size_t>(placeOf(axis));
        const std::int64_t places = grid.geometry.size[of];
        for (int other = 0; other < 3; ++other)
            for (std::int64_t place = 0; place < grid.geometry.size[static_cast<std::size_t>(other)]; ++place)
                EXPECT_EQ(same.voxelOf(other, place),
                          other == placeOf(axis) ? stored.size[of] - 1 - grid.voxelOf(other, places - 1 - place)
                                                 : grid.voxelOf(other, place));
        EXPECT_LT(length(same.geometry.origin - stored.patientFromVoxel(Vec3(static_cast<double>(same.first[0]),
                                                                             static_cast<double>(same.first[1]),
                                                                             static_cast<double>(same.first[2])))),
                  1e-9);
    }
}

}  // namespace
}  // namespace echolucent
