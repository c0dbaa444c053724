// 2D frames that MetaImage and NRRD files hold as if they were slices, as Plus and 3D Slicer write them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// Keys of `count` frames, "Seq_Frame0002_ProbeToTrackerTransform" and others, each assigned as the format does.
std::string frameKeys(int count, const std::string& assignment, bool tracked) {
    std::string text;
    for (int frame = 0; frame < count; ++frame) {
        const std::string key = fmt::format("Seq_Frame{:04}_", frame);
        if (tracked)
            text += key + "ProbeToTrackerTransform" + assignment +
                    fmt::format("1 0 0 {} 0 1 0 0 0 0 1 0 0 0 0 1\n", frame) + key + "ProbeToTrackerTransformStatus" +
                    assignment + "OK\n";
        text += key + "Timestamp" + assignment + fmt::format("{}\n", 0.1 * frame);
    }
    return text;
}

std::string framesMetaImage(const std::string& size, const std::string& more) {
    return fmt::format(
        "ObjectType = Image\nNDims = {}\nDimSize = {}\nElementSpacing = 0.2 0.25 1{}\n"
        "ElementType = MET_UCHAR\nTransformMatrix = {}\n{}ElementDataFile = LOCAL\n{}",
        size.size() > 6 ? 4 : 3, size, size.size() > 6 ? " 1" : "",
        size.size() > 6 ? "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" : "1 0 0 0 1 0 0 0 1", more, std::string(24, 'v'));
}
std::string framesNrrd(const std::string& sizes, const std::string& kinds, const std::string& more) {
    return fmt::format("NRRD0004\ntype: uchar\ndimension: {}\nsizes: {}\nkinds: {}\nencoding: raw\n{}\n{}",
                       std::count(sizes.begin(), sizes.end(), ' ') + 1, sizes, kinds, more, std::string(72, 'v'));
}

struct FramesRow {
    std::string file, bytes, words;
    Vec3 spacing;  ///< where the frames are taken as slices
    std::array<std::int64_t, 3> size{2, 3, 4};
    int sliceAxis = 2;   ///< that the frames lie along
    bool scaled = true;  ///< whether the file says the spacing within a frame
};

class FramesOverTime : public testing::TestWithParam<FramesRow> {};

TEST_P(FramesOverTime, AreRefusedWithTheWayOutAndTakenAsSlicesWhenAsked) {
    const FramesRow& row = GetParam();
    const TemporaryFolder folder;
    const std::string file = folder.write(row.file, row.bytes);
    const auto refused = readStudy(file);
    ASSERT_FALSE(refused) << "was read as a volume";
    EXPECT_TRUE(refused.error().framesCouldBeSlices);
    EXPECT_THAT(refused.error().sentence(), HasSubstr(row.words));
    EXPECT_THAT(refused.error().sentence(), HasSubstr("--frames-as-slices"));
    const auto study = readStudy(file, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 1U);
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_EQ(geometry.size, row.size);
    EXPECT_EQ(geometry.spacing, row.spacing);
    EXPECT_FALSE(geometry.spacingKnown);
    EXPECT_FALSE(geometry.patientFrameKnown);
    if (!row.scaled) {
        EXPECT_TRUE(warnsOf(*study, "spacing of the voxels is unknown"));
    } else {
        EXPECT_TRUE(warnsOf(*study, fmt::format("The distance of the slices is unknown; {:.6g} mm is assumed",
                                                row.spacing[row.sliceAxis])));
        EXPECT_TRUE(warnsOf(*study, "Within a slice the spacing is known"));
        EXPECT_FALSE(warnsOf(*study, "spacing of the voxels is unknown"));
    }
    EXPECT_EQ(sourceOf(*study, "spacing").ends_with("; distance of slices assumed"), row.scaled);
}

const std::string sweepWords = "this is a tracked 2D sweep of 4 frames, not a volume";
const std::string cineWords = "these are 2D frames over time, not a volume";

INSTANTIATE_TEST_SUITE_P(
    All, FramesOverTime,
    testing::Values(
        FramesRow{"plus.mha",
                  framesMetaImage("2 3 4", "Kinds = domain domain list\n" + frameKeys(4, " = ", true)),
                  sweepWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{"old.igs.mha", framesMetaImage("2 3 4", frameKeys(4, " = ", true)), sweepWords, {0.2, 0.25, 0.2}},
        FramesRow{"four.seq.mha", framesMetaImage("2 3 1 4", frameKeys(4, " = ", true)), sweepWords, {0.2, 0.25, 0.2}},
        FramesRow{"times.mha", framesMetaImage("2 3 4", frameKeys(4, " = ", false)), cineWords, {0.2, 0.25, 0.2}},
        FramesRow{"kind.mha", framesMetaImage("2 3 4", "Kinds = domain domain time\n"), cineWords, {0.2, 0.25, 0.2}},
        FramesRow{"plus.nrrd",
                  framesNrrd("2 3 4", "domain domain list", "spacings: 0.2 0.25 NaN\n" + frameKeys(4, ":=", true)),
                  sweepWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{
            "slicer.seq.nrrd",
            framesNrrd("4 2 3 1", "list domain domain domain",
                       "space: LPS\nspace directions: none (0.2,0,0) (0,0.25,0) (0,0,1)\n" + frameKeys(4, ":=", true)),
            sweepWords,
            {0.2, 0.2, 0.25},
            {4, 2, 3},
            0},
        FramesRow{"colour.nrrd",
                  framesNrrd("3 2 3 4", "RGB-color domain domain list",
                             "spacings: NaN 0.2 0.25 NaN\n" + frameKeys(4, ":=", true)),
                  sweepWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{"time.nrrd",
                  framesNrrd("2 3 4", "domain domain time", "spacings: 0.2 0.25 NaN\n"),
                  cineWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{"first.nrrd",
                  framesNrrd("2 3 4", "time domain domain", "spacings: NaN 0.25 0.5\n"),
                  cineWords,
                  {0.25, 0.25, 0.5},
                  {2, 3, 4},
                  0},
        FramesRow{"slice.nrrd",
                  framesNrrd("2 3 1 4", "domain domain domain time", "spacings: 0.2 0.25 1 0.04\n"),
                  "sizes has one slice and 4 time points: " + cineWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{"slice.mha",
                  framesMetaImage("2 3 1 4", ""),
                  "DimSize has one slice and 4 time points: " + cineWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{
            "unscaled.nrrd", framesNrrd("2 3 4", "domain domain time", ""), cineWords, {1, 1, 1}, {2, 3, 4}, 2, false},
        FramesRow{"colourtime.nrrd",
                  framesNrrd("3 2 3 4", "RGB-color domain domain time", "spacings: NaN 0.2 0.25 0.04\n"),
                  cineWords,
                  {0.2, 0.25, 0.2}},
        FramesRow{"directions.nrrd",
                  framesNrrd("2 3 4", "domain domain time",
                             "space: RAS\nspace directions: (0.2,0,0) (0,0.25,0) none\nspace origin: (1,2,3)\n"),
                  cineWords,
                  {0.2, 0.25, 0.2}}),
    [](const auto& row) {
        std::string name = row.param.file;
        std::replace(name.begin(), name.end(), '.', '_');
        return name;
    });

TEST(FramesOfAList, AloneMakeTheSpacingUnknownAndAreSaid) {
    const TemporaryFolder folder;
    for (const std::string& file :
         {folder.write("v.mha", framesMetaImage("2 3 4", "Kinds = domain domain list\n")),
          folder.write("v.nrrd", framesNrrd("2 3 4", "domain domain list", "spacings: 0.2 0.25 1\n"))}) {
        const auto study = readStudy(file, withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
        EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.2, 0.25, 1));
        EXPECT_TRUE(warnsOf(*study, "calls the axis z a list"));
    }
}

TEST(TrueVolumes, MayCarryKeysOfOneFrameOrOfAMovingProbe) {
    const TemporaryFolder folder;
    // A reconstructed volume keeps the state of the one frame that it is; in a moving one each phase is a volume.
    const auto reconstructed = readStudy(
        folder.write("v.mha", framesMetaImage("2 3 4", "Kinds = domain domain domain\n" + frameKeys(1, " = ", true))),
        withoutGuess());
    ASSERT_TRUE(reconstructed) << reconstructed.error().sentence();
    EXPECT_TRUE(reconstructed->phases[0]->geometry().spacingKnown);
    const auto moving =
        readStudy(folder.write("m.mha", framesMetaImage("2 3 2 2", frameKeys(2, " = ", true))), withoutGuess());
    ASSERT_TRUE(moving) << moving.error().sentence();
    EXPECT_EQ(moving->phases.size(), 2U);
    EXPECT_TRUE(moving->phases[0]->geometry().spacingKnown);
    EXPECT_TRUE(warnsOf(*moving, "its movement is left out"));
}

/// A volume over two phases, as MetaImage and as NRRD, whose frames state these spacings.
std::vector<std::pair<std::string, std::string>> withFrameSpacings(const std::string& one, const std::string& other,
                                                                   const std::string& header) {
    const auto keys = [&](const std::string& assignment) {
        return "Seq_Frame0000_ElementSpacing" + assignment + one + "\nSeq_Frame0001_ElementSpacing" + assignment +
               other + "\n";
    };
    const std::string voxels(12, 'v');
    return {{"v.mha", "NDims = 4\nDimSize = 1 2 3 2\nElementType = MET_UCHAR\n" +
                          (header.empty() ? "" : "ElementSpacing = " + header + " 1\n") + keys(" = ") +
                          "ElementDataFile = LOCAL\n" + voxels},
            {"v.nrrd", "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 2 3 2\nkinds: domain domain domain time\n" +
                           (header.empty() ? "" : "spacings: " + header + " nan\n") + "encoding: raw\n" + keys(":=") +
                           "\n" + voxels}};
}

TEST(FrameSpacing, CountsOverThatOfTheHeaderAndIsNoted) {
    const TemporaryFolder folder;
    const std::string spacing = "0.1 0.0386 0.2";
    for (const std::string header : {"1 1 1", ""})
        for (const auto& [name, bytes] : withFrameSpacings(spacing, "0.10 0.0386 0.2", header)) {
            const auto study = readStudy(folder.write(name, bytes), withoutGuess());
            ASSERT_TRUE(study) << name << study.error().sentence();
            const VolumeGeometry& geometry = study->phases[0]->geometry();
            EXPECT_EQ(geometry.spacing, Vec3(0.1, 0.0386, 0.2)) << name;
            EXPECT_TRUE(geometry.spacingKnown) << name;
            EXPECT_TRUE(warnsOf(*study, header.empty() ? "The spacing of the voxels is that of \"Seq_Frame0000"
                                                       : "1 x 1 x 1 mm; the frames count"))
                << name;
            EXPECT_EQ(sourceOf(*study, "spacing"), "\"Seq_Frame0000_ElementSpacing\" and the others") << name;
        }
    for (const auto& [name, bytes] : withFrameSpacings(spacing, spacing, spacing)) {
        const auto study = readStudy(folder.write(name, bytes), withoutGuess());
        ASSERT_TRUE(study) << name << study.error().sentence();
        EXPECT_TRUE(study->phases[0]->geometry().spacingKnown);
        EXPECT_FALSE(warnsOf(*study, "Seq_Frame")) << name;
    }
}

TEST(FrameSpacing, ThatDiffersOrIsNoneMakesTheSpacingUnknown) {
    const TemporaryFolder folder;
    for (const std::string other : {"0.1 0.0386 0.3", "0.1 0.2", "0 1 1", "nan 1 1", "x y z", "-1 1 1", "1e999 1 1"})
        for (const auto& [name, bytes] : withFrameSpacings("0.1 0.0386 0.2", other, "1 1 1")) {
            const auto study = readStudy(folder.write(name, bytes), withoutGuess());
            ASSERT_TRUE(study) << name << study.error().sentence();
            EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(1, 1, 1)) << name;
            EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << name << other;
            EXPECT_TRUE(warnsOf(*study, "\"Seq_Frame0001_ElementSpacing\"")) << name;
        }
}

}  // namespace
}  // namespace echolucent
