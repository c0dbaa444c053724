// No output of any command may be a file that was read.
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/document/document_file.h"
#include "program.h"
#include "scan_slices.h"
#include "tests/io/written_files/dicom_files.h"

namespace echolucent {
namespace {

/// A folder of inputs of every kind, small enough to be computed on quickly.
class Inputs {
public:
    Inputs() {
        write(m_folder / "v.mhd",
              "NDims = 3\nDimSize = 24 24 24\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
              "ElementDataFile = v.raw\n");
        write(m_folder / "v.raw", std::string(24 * 24 * 24, 'v'));
        write(m_folder / "n.nhdr",
              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 24 24 24\nspacings: 1 1 1\nencoding: raw\n"
              "data file: v.raw\n\n");
        write(m_folder / "plain.bin", std::string(24 * 24 * 24, 'p'));
        write(m_folder / "plain.bin.echolucent.json",
              "{\"format\": \"echolucent-raw-layout\", \"version\": 1, \"size\": [24, 24, 24]}");
        write(m_folder / "curve.json",
              "{\"format\": \"echolucent-opacity-curve\", \"version\": 1, "
              "\"nodes\": [{\"intensity\": 0.2, \"opacity\": 0}, {\"intensity\": 1, \"opacity\": 0.5}]}");
        std::filesystem::create_directory(m_folder / "series");
        for (int slice = 0; slice < 20; ++slice) {
            TestImage image = scanSlice(slice);
            image.series = slice < 18 ? "1.2.3" : "1.2.4";  // the last two belong to a series that is not shown
            writeDicom(m_folder / ("series/s" + std::to_string(slice) + ".dcm"), image);
        }
        std::filesystem::create_directory(m_folder / "refused");
        for (int series = 0; series < 2; ++series) {
            TestImage alone;
            alone.columns = alone.rows = 20;
            alone.pixels8.assign(400, 100);
            alone.series = "1.2." + std::to_string(series + 5);
            writeDicom(m_folder / ("refused/s" + std::to_string(series) + ".dcm"), alone);
        }
        Document document;
        StudyFile study;
        study.path = m_folder / "v.mhd";
        document.study = study;
        if (!writeDocument(m_folder / "d.json", document)) ADD_FAILURE() << "no document";
        std::filesystem::create_symlink(m_folder / "v.raw", m_folder / "link.png");
        std::filesystem::create_symlink(m_folder / "v.raw", m_folder / "m.avi");
        std::filesystem::create_hard_link(m_folder / "v.raw", m_folder / "hard.png");
        std::filesystem::create_directory(m_folder / "study");
        for (const char* name : {"otf.html", "render.csv", "motion.csv"})
            std::filesystem::create_symlink(m_folder / "v.raw", m_folder / (std::string("study/") + name));
    }
    [[nodiscard]] std::string path() const { return m_folder / ""; }
    /// Every file of the folder with its bytes.
    [[nodiscard]] std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path()))
            if (entry.is_regular_file()) all[entry.path().string()] = contentsOf(entry.path().string());
        return all;
    }

private:
    Folder m_folder;
};

std::string within(std::string arguments, const std::string& folder) {
    for (std::size_t at = 0; (at = arguments.find("F/", at)) != std::string::npos; at += folder.size())
        arguments.replace(at, 2, folder);
    return arguments;
}

struct OverwritingRow {
    std::string arguments;  ///< F/ stands for the folder of inputs
    std::string output, input;
};

class Overwriting : public testing::TestWithParam<OverwritingRow> {};

TEST_P(Overwriting, IsRefusedWithBothFilesNamedAndNothingWritten) {
    const Inputs inputs;
    const auto before = inputs.contents();
    const Outcome outcome = runProgram(within(GetParam().arguments, inputs.path()));
    EXPECT_EQ(outcome.status, 2) << outcome.errors;
    EXPECT_NE(outcome.errors.find(GetParam().output + ": would overwrite"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find(GetParam().input + "\", which is an input"), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_TRUE(inputs.contents() == before) << "a file was changed or left behind";
}

INSTANTIATE_TEST_SUITE_P(
    Commands, Overwriting,
    testing::Values(
        OverwritingRow{"render F/v.mhd --size 16x16 -o F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"render F/n.nhdr --size 16x16 -o F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"render F/v.mhd --size 16x16 -o F/../$(basename F/)/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"render F/v.mhd --size 16x16 -o F/link.png", "link.png", "v.raw"},
        OverwritingRow{"render F/v.mhd --size 16x16 -o F/hard.png", "hard.png", "v.raw"},
        OverwritingRow{"render F/plain.bin --size 16x16 -o F/plain.bin", "plain.bin", "plain.bin"},
        OverwritingRow{"render F/plain.bin --size 16x16 -o F/plain.bin.echolucent.json", "plain.bin.echolucent.json",
                       "plain.bin.echolucent.json"},
        OverwritingRow{"render F/series --size 16x16 -o F/series/s3.dcm", "s3.dcm", "s3.dcm"},
        OverwritingRow{"render F/series --size 16x16 -o F/series/s19.dcm", "s19.dcm", "s19.dcm"},
        OverwritingRow{"render F/v.mhd --size 16x16 --otf manual:F/curve.json -o F/curve.json", "curve.json",
                       "curve.json"},
        OverwritingRow{"render F/v.mhd --size 16x16 --initial manual:F/curve.json -o F/curve.json", "curve.json",
                       "curve.json"},
        OverwritingRow{"otf F/v.mhd --json F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"otf F/v.mhd --json F/o.json --csv F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"otf F/v.mhd --json F/o.json --tubes-csv F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"otf F/v.mhd --initial manual:F/curve.json --json F/curve.json", "curve.json", "curve.json"},
        OverwritingRow{"sweep F/v.mhd --from 0 --to 2 --csv F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"sweep F/v.mhd --from 0 --to 2 --csv F/o.csv --json F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"sweep F/v.mhd --from 0 --to 2 --csv F/o.csv --movie F/m.avi", "m.avi", "v.raw"},
        OverwritingRow{"sweep F/v.mhd --from 0 --to 2 --initial manual:F/curve.json --csv F/curve.json", "curve.json",
                       "curve.json"},
        OverwritingRow{"sweep F/v.mhd --from 0 --to 2 --picture-flicker --json F/hard.png", "hard.png", "v.raw"},
        OverwritingRow{"quiet F/v.mhd -o F/v.mhd", "v.mhd", "v.mhd"},
        OverwritingRow{"quiet F/v.mhd -o F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"info F/v.mhd --json F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"info F/series --json F/series/s3.dcm", "s3.dcm", "s3.dcm"},
        OverwritingRow{"info F/refused --json F/refused/s1.dcm", "s1.dcm", "s1.dcm"},
        OverwritingRow{"files F/ -o F/series/s3.dcm", "s3.dcm", "s3.dcm"},
        OverwritingRow{"files F/ -o F/hard.png", "hard.png", "hard.png"},
        OverwritingRow{"files F/ -o F/curve.json", "curve.json", "curve.json"},
        OverwritingRow{"render --document F/d.json --size 16x16 -o F/d.json", "d.json", "d.json"},
        OverwritingRow{"render --document F/d.json --size 16x16 -o F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"render --document F/d.json F/n.nhdr --size 16x16 -o F/d.json", "d.json", "d.json"},
        OverwritingRow{"otf --document F/d.json --csv F/d.json", "d.json", "d.json"},
        OverwritingRow{"otf --document F/d.json --tubes-csv F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"sweep --document F/d.json --from 0 --to 2 --json F/d.json", "d.json", "d.json"},
        OverwritingRow{"sweep --document F/d.json --from 0 --to 2 --csv F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"bench otf F/v.mhd --runs 1 --json F/v.raw", "v.raw", "v.raw"},
        OverwritingRow{"study otf F/v.mhd --repeats 1 -o F/study", "otf.html", "v.raw"},
        OverwritingRow{"study render F/v.mhd --quick -o F/study", "render.csv", "v.raw"},
        OverwritingRow{"study motion F/v.mhd --from 0 --to 2 -o F/study", "motion.csv", "v.raw"}));

TEST(Overwriting, AnotherFileInTheFolderOfTheInputsIsReplaced) {
    const Inputs inputs;
    for (const char* volume : {"v.mhd", "series"}) {
        const std::string picture = inputs.path() + "series/picture.png";
        write(picture, "an older picture");
        const Outcome outcome =
            runProgram("render \"" + inputs.path() + volume + "\" --size 16x16 --otf linear -o \"" + picture + "\"");
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_EQ(contentsOf(picture).substr(1, 3), "PNG");
    }
}

TEST(Overwriting, TwoSpellingsOfOneOutputAreOneFile) {
    const Inputs inputs;
    for (const char* arguments : {"otf F/v.mhd --json F/new.txt --csv F/study/../new.txt",
                                  "otf F/v.mhd --json echolucent-new.txt --csv ./echolucent-new.txt"}) {
        const Outcome outcome = runProgram(within(arguments, inputs.path()));
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.errors.find("named twice"), std::string::npos) << outcome.errors;
    }
    EXPECT_FALSE(std::filesystem::exists(inputs.path() + "new.txt"));
}

}  // namespace
}  // namespace echolucent
