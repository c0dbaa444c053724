#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "dicom_files.h"
#include "kretz_files.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

std::string kretzSentence(const std::string& bytes, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.vol", bytes), options);
    return study ? "was read" : study.error().sentence();
}

/// The position of a sample by the toroidal formulas that are published for the format, mm.
struct Toroidal {
    double resolution = 0.5, offset1 = 80, offset2 = -30;
    [[nodiscard]] Vec3 at(double i, double theta, double phi) const {
        const double bigR = -offset2 * resolution, r = (offset1 + i) * resolution;
        const double th = theta - std::numbers::pi / 2, ph = phi - std::numbers::pi / 2;
        return {r * std::sin(th), -(r * std::cos(th) - bigR) * std::sin(ph),
                bigR * (1 - std::cos(ph)) + r * std::cos(th) * std::cos(ph)};
    }
};

TEST(Kretz, IsReadWithItsReport) {
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.v00", KretzParts().bytes()));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(factOf(*study, "format"), "GE Voluson volume (Kretz)");
    EXPECT_EQ(factOf(*study, "polar volume"), "wobbler: 20 samples x 5 lines x 4 planes");
    EXPECT_EQ(factOf(*study, "range"), "0 to 9.5 mm from the probe's face, a sample every 0.5 mm");
    EXPECT_THAT(factOf(*study, "lines"), HasSubstr("about an axis 40 mm behind the probe's face"));
    EXPECT_THAT(factOf(*study, "planes"), HasSubstr("about an axis 25 mm behind the probe's face"));
    EXPECT_THAT(factOf(*study, "memory of the scan conversion"), HasSubstr("the limit is 64 MiB a phase"));
    EXPECT_THAT(factOf(*study, "beam"), HasSubstr("+z"));
    for (const ImportFact& fact : study->facts) {
        EXPECT_THAT(fact.value, testing::Not(HasSubstr("Doe")));
        if (fact.name == "voxels without data") {
            EXPECT_THAT(fact.source, HasSubstr("geometry of the beams"));
        }
        if (fact.name == "spacing") {
            EXPECT_THAT(fact.source, HasSubstr("finest resolution"));
        }
    }
    for (const char* name : {"range", "lines", "planes"})
        EXPECT_THAT(sourceOf(*study, name), testing::EndsWith("; assumed: the first sample lies on the probe's face"));
    EXPECT_THAT(sourceOf(*study, "lines"), testing::StartsWith("C300:0002, C200:0001;"));
    const Volume& volume = *study->phases.front();
    ASSERT_TRUE(volume.geometry().probe);
    EXPECT_EQ(volume.geometry().probe->forward, Vec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(volume.geometry().spacing[0], 0.5);
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        ASSERT_EQ(volume.storedValue(i), volume.hasData(i) ? 'v' : 0);
}

// Each sample is bright by itself in turn; the brightest voxel lies where the published formulas put it.
TEST(Kretz, SamplesLieWhereThePublishedFormulasPutThem) {
    const std::vector<double> phis{1.4, 1.5, 1.6, 1.7}, thetas{1.3, 1.4, 1.5, 1.6, 1.7};
    const Toroidal toroidal;
    for (const auto& [i, j, k] :
         {std::array{10, 1, 1}, std::array{3, 3, 1}, std::array{15, 2, 2}, std::array{8, 1, 2}}) {
        KretzParts parts;
        std::string voxels(400, '\0');
        voxels[static_cast<std::size_t>(i + 20 * (j + 5 * k))] = '\xff';
        parts.voxels = kretzItem(0xD000, 1, voxels);
        const TemporaryFolder folder;
        const auto study = readStudy(folder.write("v.vol", parts.bytes()));
        ASSERT_TRUE(study) << study.error().sentence();
        const Volume& volume = *study->phases.front();
        const VolumeGeometry& geometry = volume.geometry();
        Vec3 brightest;
        double most = 0;
        for (std::int64_t z = 0; z < geometry.size[2]; ++z)
            for (std::int64_t y = 0; y < geometry.size[1]; ++y)
                for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                    if (const double value = volume.storedValue(geometry.offset(x, y, z)); value > most) {
                        most = value;
                        brightest = geometry.patientFromVoxel(
                            {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
                    }
        // The formulas count depth from the axis of the lines, 40 mm behind the face.
        const Vec3 truth =
            toroidal.at(i, thetas[static_cast<std::size_t>(j)], phis[static_cast<std::size_t>(k)]) - Vec3(0, 0, 40);
        EXPECT_LT(length(brightest - truth), 0.6) << i << " " << j << " " << k;
    }
}

TEST(Kretz, CartesianVolumeKeepsItsVoxels) {
    KretzParts parts;
    parts.planeAngles = parts.lineAngles = parts.firstSample = parts.planesAxis = "";
    std::string voxels;
    for (int i = 0; i < 400; ++i) voxels.push_back(static_cast<char>(i % 251));
    parts.voxels = kretzItem(0xD000, 1, voxels);
    parts.more = kretzNumbers(0x0010, 0x0022, {0.4});
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.vol", parts.bytes()), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases.front();
    EXPECT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{20, 5, 4}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.4, 0.4, 0.4));
    EXPECT_EQ(sourceOf(*study, "spacing"), "0010:0022, assumed to be mm");
    for (std::int64_t i = 0; i < 400; ++i) ASSERT_EQ(volume.storedValue(i), static_cast<double>(i % 251));
    EXPECT_TRUE(warnsOf(*study, "two spacings, 0.4 mm (0010:0022) and 0.5 mm (C100:0001)"));
    EXPECT_FALSE(volume.geometry().probe);

    parts.more = "";
    const auto byResolution = readStudy(folder.write("r.vol", parts.bytes()), withoutGuess());
    ASSERT_TRUE(byResolution);
    EXPECT_EQ(byResolution->phases.front()->geometry().spacing, Vec3(0.5, 0.5, 0.5));
    parts.resolution = "";
    const auto unknown = readStudy(folder.write("u.vol", parts.bytes()), withoutGuess());
    ASSERT_TRUE(unknown);
    EXPECT_FALSE(unknown->phases.front()->geometry().spacingKnown);
}

TEST(Kretz, PhasesStandInASequenceOrOneByOne) {
    const auto phaseValues = [](const KretzParts& parts) {
        const TemporaryFolder folder;
        const auto study = readStudy(folder.write("v.vol", parts.bytes()));
        std::vector<double> values;
        if (!study) return values;
        for (const auto& phase : study->phases) {
            const auto mask = phase->dataMask();
            const auto first = std::find(mask.begin(), mask.end(), 1) - mask.begin();
            values.push_back(phase->storedValue(first));
        }
        return values;
    };
    KretzParts parts;
    parts.more = kretzItem(0xD600, 1, std::string(400, '\1') + std::string(400, '\2') + std::string(400, '\3'));
    EXPECT_THAT(phaseValues(parts), testing::ElementsAre(1, 2, 3));
    parts.more = kretzItem(0xD000, 1, std::string(400, '\7'));
    EXPECT_THAT(phaseValues(parts), testing::ElementsAre('v', 7));
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.vol", parts.bytes()));
    ASSERT_TRUE(study);
    EXPECT_EQ(sourceOf(*study, "phases"), "D000:0001, which stands several times: assumed to be phases");
}

TEST(Kretz, WhatIsLeftOutIsSaid) {
    KretzParts parts;
    parts.more = kretzItem(0xD000, 2, std::string(400, 'f')) + kretzItem(0xD000, 0x0101, std::string(400, 'c')) +
                 kretzItem(0xD000, 0x0201, std::string(400, 'p'));
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.vol", parts.bytes()));
    ASSERT_TRUE(study);
    EXPECT_EQ(study->phases.size(), 1U);
    EXPECT_TRUE(warnsOf(*study, "a filtered copy of the volume (D000:0002)"));
    EXPECT_TRUE(warnsOf(*study, "a volume of colour flow (D000:0101)"));
    EXPECT_TRUE(warnsOf(*study, "a volume of power Doppler (D000:0201)"));
}

TEST(Kretz, AnyCutEndsInASentence) {
    const std::string whole = KretzParts().bytes();
    int refused = 0;
    for (std::size_t length = 16; length < whole.size(); ++length) {
        const std::string sentence = kretzSentence(whole.substr(0, length));
        EXPECT_THAT(sentence, HasSubstr(sentence == "was read" ? "was read" : "v.vol: ")) << length;
        refused += sentence == "was read" ? 0 : 1;
    }
    // A file that ends behind the voxels lacks nothing.
    EXPECT_GE(refused, static_cast<int>(whole.size()) - 16 - 9);
}

TEST(Kretz, CancelledReadingEndsAsCancelled) {
    const PolarGeometry polar = polarGeometry({}, {100, 100, 100});
    const TemporaryFolder folder;
    ASSERT_TRUE(writeKretz(folder.file("v.vol"), polar, {std::vector<std::uint8_t>(1000000, 9)}));
    for (const double when : {0.0, 0.801}) {
        std::atomic<bool> cancel = false;
        Progress progress;
        progress.cancel = &cancel;
        progress.report = [&](double share) { cancel = cancel || share >= when; };
        const auto study = readStudy(folder.file("v.vol"), {}, progress);
        ASSERT_FALSE(study);
        EXPECT_EQ(study.error().kind, FailureKind::cancelled) << when;
    }
}

TEST(Kretz, MemoryLimitWidensTheSpacingAndIsSaid) {
    const PolarGeometry polar = polarGeometry({}, {200, 200, 100});
    const TemporaryFolder folder;
    ASSERT_TRUE(writeKretz(folder.file("v.vol"), polar, {std::vector<std::uint8_t>(4000000, 9)}));
    ReadOptions options;
    options.conversionMebibytes = 1;
    const auto study = readStudy(folder.file("v.vol"), options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_LE(study->phases.front()->geometry().voxelCount(), 1 << 20);
    EXPECT_GT(study->phases.front()->geometry().voxelCount(), 1000000);
    EXPECT_THAT(factOf(*study, "memory of the scan conversion"), HasSubstr("the limit is 1 MiB a phase and 8 MiB"));
    for (const ImportFact& fact : study->facts)
        if (fact.name == "spacing") {
            EXPECT_THAT(fact.source, HasSubstr("widened to the memory limit"));
        }
}

TEST(Kretz, WriterThrowsWhereTheFormatHasNoWords) {
    const PolarGeometry linear = polarGeometry({PolarKind::linear, 0, 1, {-2, 2}, {-2, 2}, 0, 0}, {2, 2, 2});
    EXPECT_THROW((void)kretzBytes(linear, {std::vector<std::uint8_t>(8)}), std::invalid_argument);
    const PolarGeometry wobbler = polarGeometry({}, {2, 2, 2});
    EXPECT_THROW((void)kretzBytes(wobbler, {}), std::invalid_argument);
    EXPECT_THROW((void)kretzBytes(wobbler, {std::vector<std::uint8_t>(9)}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
