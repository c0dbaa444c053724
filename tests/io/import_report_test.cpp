// The import report: every number says where it came from, whatever the format.
#include "io/study/import_report.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/writers/enhanced_us_writer.h"
#include "io/writers/kretz_writer.h"
#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "shared_data.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// A volume of words, so that byte order and white level are to be told too.
std::shared_ptr<const Volume> words() {
    VolumeGeometry geometry;
    geometry.size = {6, 5, 4};
    std::vector<std::uint16_t> voxels(120);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint16_t>(10 * i);
    return std::make_shared<const Volume>(geometry, Voxels(std::move(voxels)), 1200.0);
}

void expectEverySourceIsSaid(const std::string& path, const ReadOptions& options = {}) {
    const auto study = readStudy(path, options);
    ASSERT_TRUE(study) << study.error().sentence();
    const auto beam = guessBeamAxis(*study->phases.front());
    const std::vector<ImportFact> report = importReport(*study, *beam);
    std::vector<std::string> names;
    for (const ImportFact& fact : report) {
        EXPECT_FALSE(fact.value.empty()) << path << ": " << fact.name;
        EXPECT_FALSE(fact.source.empty()) << path << ": " << fact.name << " is " << fact.value;
        EXPECT_EQ(fact.value.find("1.2.840."), std::string::npos) << path << ": " << fact.value << " is no word";
        names.push_back(fact.name);
    }
    for (const char* needed :
         {"format", "size", "spacing", "voxel type", "white level", "voxels without data", "lossy compression", "beam"})
        EXPECT_EQ(std::count(names.begin(), names.end(), needed), 1) << path << ": " << needed;
}

TEST(ImportReport, EveryNumberOfWrittenFilesSaysItsSource) {
    const TemporaryFolder folder;
    const std::vector phases{words(), words()};
    ASSERT_TRUE(writeMetaImage(folder.file("a.mha"), phases));
    ASSERT_TRUE(writeNifti(folder.file("a.nii.gz"), phases, 0.04));
    ASSERT_TRUE(writeEnhancedUs(folder.file("a.dcm"), phases, {}));
    const PolarGeometry polar = polarGeometry(EvenPolar{}, {20, 12, 10});
    ASSERT_TRUE(writeKretz(folder.file("a.vol"), polar, {std::vector<std::uint8_t>(2400, 9)}));
    folder.write("a.raw", std::string(2400, 'v'));
    RawLayout beams;
    beams.size = {20, 12, 10};
    beams.polar = polar;
    ASSERT_TRUE(rememberRawLayout(folder.file("a.raw"), beams));
    folder.write("b.raw", std::string(120, 'v'));
    ReadOptions raw;
    raw.raw.emplace();
    raw.raw->size = {6, 5, 4};
    for (const char* name : {"a.mha", "a.nii.gz", "a.dcm", "a.vol", "a.raw"})
        expectEverySourceIsSaid(folder.file(name));
    expectEverySourceIsSaid(folder.file("b.raw"), raw);
}

TEST(ImportReport, EveryNumberOfRealFilesSaysItsSource) {
    SKIP_WITHOUT_SHARED_DATA();
    int opened = 0;
    for (const char* folder : {"/volumes", "/dicom"})
        for (const auto& entry : std::filesystem::directory_iterator(sharedData + folder)) {
            ReadOptions options;
            options.framesAsSlices = true;
            options.guessNoData = false;  // the guess takes the time of this test
            if (!readStudy(entry.path().string(), options)) continue;
            expectEverySourceIsSaid(entry.path().string(), options);
            ++opened;
        }
    EXPECT_GE(opened, 20);
}

}  // namespace
}  // namespace echolucent
