// The mutations themselves: the seed decides them, and they leave files that readers go into.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "fuzz_target.h"
#include "io/file_formats.h"
#include "io/study/study.h"
#include "mutations/dicom_elements.h"
#include "samples/dicom_samples.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

TEST(Mutations, AreDecidedByTheirSeed) {
    for (const FuzzTarget* target : fuzzTargets()) {
        const std::string bytes = target->samples().front().bytes;
        std::set<std::string> different;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const std::string changed = target->mutated(bytes, seed);
            EXPECT_EQ(target->mutated(bytes, seed), changed) << target->name << " " << seed;
            different.insert(changed);
        }
        EXPECT_GT(different.size(), 20u) << target->name;
    }
}

TEST(Mutations, TakeAnythingForAFile) {
    for (const FuzzTarget* target : fuzzTargets())
        for (const std::string& bytes : {std::string(), std::string("x"), std::string(5000, '\0'),
                                         std::string(300, '\xff'), std::string(200, '[')})
            for (std::uint64_t seed = 0; seed < 20; ++seed)
                EXPECT_LE(target->mutated(bytes, seed).size(), std::size_t{1} << 20) << target->name;
}

TEST(DicomElements, AreTakenApartAndPutTogetherAgain) {
    for (const FuzzSample& sample : dicomSamples()) {
        const DicomFileBytes parts = dicomParts(sample.bytes);
        if (!parts.deflated) {
            EXPECT_EQ(dicomBytes(parts), sample.bytes) << sample.name;
        }
        if (sample.name == "big") continue;
        EXPECT_TRUE(parts.rest.empty()) << sample.name << " holds " << parts.rest.size() << " bytes that are not read";
        EXPECT_GT(parts.elements.size(), 9u) << sample.name;
    }
}

/// What the samples are opened as; those that a target needs other files for are left out.
const std::vector<std::pair<const FuzzTarget*, std::string>> volumeReaders{{&metaImageTarget, "v.mha"},
                                                                           {&nrrdTarget, "v.nrrd"},
                                                                           {&niftiTarget, "v.nii"},
                                                                           {&kretzTarget, "v.vol"},
                                                                           {&dicomTarget, "v.dcm"}};

TEST(Samples, OpenUnlessTheyAreMadeToBeRefusedOrNeedOtherFiles) {
    const std::set<std::string> refused{"frames", "apart", "list", "pattern", "slice"};
    for (const auto& [target, file] : volumeReaders)
        for (const FuzzSample& sample : target->samples()) {
            const TemporaryFolder folder;
            const auto study = readStudy(folder.write(file, sample.bytes));
            EXPECT_EQ(study.has_value(), !refused.contains(sample.name))
                << target->name << " " << sample.name << ": " << (study ? "opens" : study.error().sentence());
        }
}

TEST(Samples, OfFragmentsOpenInTheHeaderTheyAreWrappedIn) {
    for (const FuzzSample& sample : fragmentSamples()) {
        const TemporaryFolder folder;
        const auto form = static_cast<std::size_t>(sample.bytes.front());
        const auto study = readStudy(folder.write("v.dcm", dicomOfFragment(form, sample.bytes.substr(1))));
        EXPECT_TRUE(study) << sample.name << ": " << study.error().sentence();
    }
}

// A new format comes with its target.
TEST(Samples, BeginAsEveryFormatThatIsRead) {
    std::set<const FileFormat*> begun;
    for (const FuzzTarget* target : fuzzTargets())
        for (const FuzzSample& sample : target->samples())
            begun.insert(formatFromContent(sample.bytes.substr(0, 4096)));
    for (const FileFormat& format : fileFormats()) EXPECT_TRUE(begun.contains(&format)) << format.name;
}

/// How many of 300 mutations of the first sample still open as a study.
int openedOf(const FuzzTarget& target, const std::string& file) {
    const TemporaryFolder folder;
    const std::string bytes = target.samples().front().bytes;
    int opened = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        opened += readStudy(folder.write(file, target.mutated(bytes, seed))).has_value() ? 1 : 0;
    return opened;
}

// Bytes that change anywhere seldom leave a file; changes by the format's own parts often do.
TEST(Mutations, OftenLeaveFilesThatOpenAndOftenFilesThatDoNot) {
    for (const auto& [target, file] : volumeReaders) {
        const int opened = openedOf(*target, file);
        EXPECT_GT(opened, 20) << target->name;
        EXPECT_LT(opened, 280) << target->name;
    }
}

}  // namespace
}  // namespace echolucent
