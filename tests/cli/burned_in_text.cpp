// What is said of text in the pictures of a file before a picture or movie of them is written.
#include <string>
#include <vector>

#include "program.h"
#include "scan_slices.h"
#include "tests/io/written_files/dicom_files.h"

namespace echolucent {
namespace {

/// A folder of slices that state this, or nothing, of text in their pixels; screens are captured, as in a cine.
void writeSlices(const Folder& folder, const std::string& stated) {
    std::filesystem::create_directory(folder / "series");
    for (int slice = 0; slice < 12; ++slice) {
        TestImage image = scanSlice(slice);
        image.burnedInAnnotation = stated;
        writeDicom(folder / ("series/s" + std::to_string(slice) + ".dcm"), image);
    }
}

TEST(BurnedInText, IsSaidWhereAPictureOrMovieIsWrittenAndNowhereElse) {
    for (const std::string stated : {"YES", "NO"}) {
        const Folder folder;
        writeSlices(folder, stated);
        const std::string study = "\"" + folder / "series" + "\"", out = "\"" + folder / "out";
        for (const auto& [arguments, ofPictures] : std::vector<std::pair<std::string, bool>>{
                 {"render " + study + " --otf linear --size 16x16 -o " + out + ".png\"", true},
                 {"sweep " + study + " --from 0 --to 1 --size 16x16 --movie " + out + ".avi\"", true},
                 {"sweep " + study + " --from 0 --to 1 --csv " + out + ".csv\"", false},
                 {"otf " + study + " --json " + out + ".json\"", false}}) {
            const Outcome outcome = runProgram(arguments);
            EXPECT_EQ(outcome.status, 0) << outcome.errors;
            const bool said = outcome.errors.find("may show names burnt into the pictures.") != std::string::npos;
            EXPECT_EQ(said, stated == "YES" && ofPictures) << arguments << ": " << outcome.errors;
        }
    }
}

}  // namespace
}  // namespace echolucent
