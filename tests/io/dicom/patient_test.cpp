// The patient is read from DICOM files where a person asks for it, in UTF-8, and never of two persons.
#include "io/dicom/patient.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "tests/io/written_files/dicom_files.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

class PatientTest : public testing::Test {
protected:
    /// Writes a picture with these attributes.
    std::string write(const std::string& name, const std::vector<std::pair<DcmTagKey, std::string>>& attributes,
                      const std::string& series = "1.2.3") {
        const std::string path = m_folder.path() + "/" + name;
        TestImage image;
        image.series = series;
        image.pixels8.assign(12, 7);
        writeDicom(path, image);
        DcmFileFormat file;
        EXPECT_TRUE(file.loadFile(path.c_str()).good());
        for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID})  // those that every file of the tests has
            EXPECT_TRUE(file.getDataset()->findAndDeleteElement(tag).good());
        for (const auto& [tag, text] : attributes)
            EXPECT_TRUE(file.getDataset()->putAndInsertString(tag, text.c_str()).good());
        EXPECT_TRUE(file.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
        return path;
    }
    TemporaryFolder m_folder;
};

const std::vector<std::pair<DcmTagKey, std::string>> jane{{DCM_PatientName, "DOE^JANE"},
                                                          {DCM_PatientID, "4711"},
                                                          {DCM_PatientBirthDate, "19800517"},
                                                          {DCM_PatientSex, "F"},
                                                          {DCM_StudyDate, "20240229"}};

TEST_F(PatientTest, TheFileSaysWhoseItIs) {
    const auto patient = readPatient({write("a.dcm", jane)});
    ASSERT_TRUE(patient) << patient.error().sentence();
    EXPECT_EQ(*patient, (Patient{"DOE^JANE", "4711", "1980-05-17", "F", "2024-02-29"}));
}

TEST_F(PatientTest, TheGestationalAgeCountsFromTheLastMenstruation) {
    const auto age = [this](const std::string& lastMenstruation, const std::string& study) {
        const auto patient =
            readPatient({write("a.dcm", {{DCM_LastMenstrualDate, lastMenstruation}, {DCM_StudyDate, study}})});
        return patient ? patient->gestationalAge : "no patient";
    };
    EXPECT_EQ(age("20230924", "20240229"), "22+4");  // 158 days
    EXPECT_EQ(age("20240229", "20240229"), "0+0");
    EXPECT_EQ(age("20240301", "20240229"), "") << "after the exam";
    EXPECT_EQ(age("20220101", "20240229"), "") << "too long ago";
    EXPECT_EQ(age("20231341", "20240229"), "") << "no day of a calendar";
    EXPECT_EQ(age("", "20240229"), "");
    EXPECT_EQ(age("20230924", ""), "");
}

TEST_F(PatientTest, WhatIsMissingIsEmptyAndWhatIsNoDateStaysAsItIs) {
    const auto patient = readPatient({write("a.dcm", {{DCM_PatientBirthDate, "1980"}})});
    ASSERT_TRUE(patient);
    EXPECT_EQ(*patient, (Patient{"", "", "1980", "", ""}));
}

TEST_F(PatientTest, NamesOfOtherCharacterSetsAreReadInUtf8) {
    if (!DcmSpecificCharacterSet::isConversionAvailable()) GTEST_SKIP() << "this DCMTK converts no character sets";
    const auto patient = readPatient(
        {write("a.dcm", {{DCM_SpecificCharacterSet, "ISO_IR 100"}, {DCM_PatientName, "M\xfcller^J\xf6rg"}})});
    ASSERT_TRUE(patient);
    EXPECT_EQ(patient->name, "Müller^Jörg");
}

TEST_F(PatientTest, FilesOfTwoPatientsNameNobody) {
    auto other = jane;
    other[0].second = "ROE^RICHARD";
    const std::vector<std::string> files{write("a.dcm", jane, "1.2.3"), write("b.dcm", other, "1.2.4")};
    const auto both = readPatient(files);
    ASSERT_FALSE(both);
    EXPECT_EQ(both.error().kind, FailureKind::unreadable);
    EXPECT_EQ(both.error().sentence().find("DOE"), std::string::npos);
    // Of a series of one of them it can be told.
    const auto one = readPatient(files, "1.2.4");
    ASSERT_TRUE(one);
    EXPECT_EQ(one->name, "ROE^RICHARD");
    // A series that no file has says nothing about whose it is.
    EXPECT_FALSE(readPatient(files, "1.2.5"));
}

TEST_F(PatientTest, WhatFilesDoNotAgreeOnStaysEmpty) {
    auto first = jane, second = jane;
    first.emplace_back(DCM_LastMenstrualDate, "20230924");
    second[2].second = "19800518";
    second[4].second = "20240301";
    second.emplace_back(DCM_LastMenstrualDate, "20230925");  // the same age on another day
    const auto patient = readPatient({write("a.dcm", first), write("b.dcm", second)});
    ASSERT_TRUE(patient);
    EXPECT_EQ(*patient, (Patient{"DOE^JANE", "4711", "", "F", ""}));
}

TEST(WithTyped, AFilesAgeIsThatOfItsDate) {
    const Patient file{"DOE^JANE", "4711", "1980-05-17", "F", "2024-02-29", "22+4"};
    EXPECT_EQ(withTyped(file, {"Roe", "", "", "", ""}),
              (Patient{"Roe", "4711", "1980-05-17", "F", "2024-02-29", "22+4"}));
    EXPECT_EQ(withTyped(file, {"", "", "", "", "2024-02-29"}).gestationalAge, "22+4");
    EXPECT_EQ(withTyped(file, {"", "", "", "", "2024-03-07"}).gestationalAge, "");
    EXPECT_EQ(withTyped(file, {"", "", "", "", "2024-03-07", "23+4"}).gestationalAge, "23+4");
}

TEST_F(PatientTest, OtherFilesArePassedOver) {
    const std::string text = m_folder.path() + "/notes.txt";
    std::ofstream(text) << "no DICOM";
    const std::string scan = write("a.dcm", jane);
    EXPECT_FALSE(areDicomFiles({}));
    EXPECT_FALSE(areDicomFiles({text}));
    EXPECT_TRUE(areDicomFiles({scan, text}));
    EXPECT_TRUE(readPatient({text, scan}));
    const auto none = readPatient({text});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, FailureKind::unreadable);
}

TEST_F(PatientTest, ReadingCanBeCancelled) {
    const std::string scan = write("a.dcm", jane);
    const std::atomic<bool> cancel = true;
    const auto patient = readPatient({scan}, {}, {nullptr, &cancel});
    ASSERT_FALSE(patient);
    EXPECT_EQ(patient.error().kind, FailureKind::cancelled);
}

}  // namespace
}  // namespace echolucent
