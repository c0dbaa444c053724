// What a listed series is called, and that nothing of its patient's name is shown.
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// The description that is listed of one picture of a patient of this name.
std::string descriptionBeside(const std::string& name, const std::string& description, const std::string& id = "") {
    const TemporaryFolder folder;
    DicomBytes file;
    file.text(0x0008, 0x103e, "LO", description).text(0x0010, 0x0010, "PN", name).text(0x0010, 0x0020, "LO", id);
    folder.write("a", file.picture(4, 2, 0).put(0x7fe0, 0x0010, "OW", std::string(8, 'a')).file(pictureClass));
    const auto list = listSeries(folder.path());
    EXPECT_TRUE(list) << list.error().sentence();
    return list ? list->series[0].description : "";
}

TEST(SeriesDescription, ShortNamesAreComparedAsWholeWords) {
    EXPECT_EQ(descriptionBeside("Wu^Li", "wu 4-chamber"), "");
    EXPECT_EQ(descriptionBeside("Wu^Li", "heart (LI)"), "");
    EXPECT_EQ(descriptionBeside("Wu^Li", "left limb"), "left limb") << "li stands in limb";
    EXPECT_EQ(descriptionBeside("Smith-Jones^A", "jones"), "");
    EXPECT_EQ(descriptionBeside("Muster^Anna", "fetus 7", "7"), "");
}

TEST(SeriesDescription, NamesOutsideAsciiLeaveNoDescription) {
    EXPECT_EQ(descriptionBeside("M\xc3\xbcller^Anna", "M\xc3\x9cLLER 2"), "") << "the case of other letters";
    EXPECT_EQ(descriptionBeside("M\xfcller^Anna", "heart"), "") << "whatever character set that is";
    EXPECT_EQ(descriptionBeside("Yamada^Tarou=\x1b$B;3ED", "heart"), "") << "an escape to another character set";
    EXPECT_EQ(descriptionBeside("Muster^Anna", "f\xc3\xb6tus"), "f\xc3\xb6tus");
}

}  // namespace
}  // namespace echolucent
