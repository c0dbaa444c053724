// Checksums of studies: those of xxHash's own program, and a study that moved is found by them.
#include "io/study/study_checksum.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

namespace fs = std::filesystem;

std::string written(const std::string& path, const std::string& bytes) {
    fs::create_directories(fs::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

StudyFile studyAt(const std::string& path, const std::vector<std::string>& files) {
    return withChecksum(StudyFile{.path = path, .options = {}, .checksum = {}}, checksumOf(files).value());
}

TEST(StudyChecksum, IsThatOfOneFilesBytes) {
    const TemporaryFolder folder;
    // As `xxhsum -H128` prints them.
    const auto empty = checksumOf({written(folder.file("empty"), "")});
    ASSERT_TRUE(empty);
    EXPECT_EQ(empty->text, "xxh3-128:99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(empty->bytes, 0);
    EXPECT_EQ(empty->files, 1);
    const auto letters = checksumOf({written(folder.file("letters"), "abc")});
    ASSERT_TRUE(letters);
    EXPECT_EQ(letters->text, "xxh3-128:06b05ab6733a618578af5f94892f3950");
    EXPECT_EQ(letters->bytes, 3);
    EXPECT_FALSE(checksumOf({folder.file("absent")}));
}

TEST(StudyChecksum, OfSeveralFilesKnowsNeitherOrderNorNames) {
    const TemporaryFolder folder;
    const std::string one = written(folder.file("one"), std::string(5'000'000, 'x') + "1");
    const std::string two = written(folder.file("two"), "2");
    const auto both = checksumOf({one, two});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->bytes, 5'000'002);
    EXPECT_EQ(both->files, 2);
    EXPECT_EQ(checksumOf({two, one}).value(), *both);
    EXPECT_NE(checksumOf({one}).value().text, both->text);
    written(two, "3");
    EXPECT_NE(checksumOf({one, two}).value().text, both->text);
}

TEST(StudyChecksum, SaysWhatChanged) {
    const TemporaryFolder folder;
    const std::string file = written(folder.file("scan.mha"), "0123456789");
    const StudyFile study = studyAt(file, {file});
    EXPECT_EQ(changeOf(study, checksumOf({file}).value()), "");
    written(file, "0123456780");
    EXPECT_EQ(changeOf(study, checksumOf({file}).value()), "has other bytes than when the session was saved");
    written(file, "012");
    EXPECT_EQ(changeOf(study, checksumOf({file}).value()), "has 3 bytes, and had 10 when the session was saved");
    const std::string more = written(folder.file("more"), "1");
    EXPECT_EQ(changeOf(study, checksumOf({file, more}).value()),
              "is read from 2 files, and was read from 1 when the session was saved");
    StudyFile unknown = study;
    unknown.checksum.clear();
    EXPECT_EQ(changeOf(unknown, checksumOf({file, more}).value()), "");
}

TEST(StudySearch, FindsAFileUnderAnotherNameAndAFolderBelow) {
    const TemporaryFolder folder;
    const std::string file = written(folder.file("a/scan.mha"), "the voxels");
    const StudyFile study = studyAt(file, {file});
    written(folder.file("a/b/other.mha"), "THE VOXELS");  // as many bytes
    const std::string moved = folder.file("a/b/c/renamed.mha");
    fs::create_directories(fs::path(moved).parent_path());
    fs::rename(file, moved);
    EXPECT_EQ(findStudy(study, {.folders = {folder.file("a")}, .paths = {}}), moved);
    EXPECT_EQ(findStudy(study, {.folders = {}, .paths = {folder.file("gone"), moved}}), moved);
    EXPECT_FALSE(findStudy(study, {.folders = {folder.file("nowhere")}, .paths = {}}));
    StudyFile unknown = study;
    unknown.checksum.clear();
    EXPECT_FALSE(findStudy(unknown, {.folders = {folder.file("a")}, .paths = {}}));

    const std::string one = written(folder.file("slices/1.dcm"), "one"),
                      two = written(folder.file("slices/2.dcm"), "2");
    const StudyFile slices = studyAt(folder.file("slices"), {one, two});
    fs::create_directories(folder.file("x"));
    fs::rename(folder.file("slices"), folder.file("x/elsewhere"));
    EXPECT_EQ(findStudy(slices, {.folders = {folder.file("x")}, .paths = {}}), folder.file("x/elsewhere"));
}

TEST(StudySearch, TellsAHeaderWithItsVoxelsFromAnothersOfThatName) {
    const TemporaryFolder folder;
    const std::string header = written(folder.file("own/volume.mhd"), "header"),
                      voxels = written(folder.file("own/voxels.raw"), "voxels");
    const StudyFile study = studyAt(folder.file("gone/volume.mhd"), {header, voxels});
    written(folder.file("others/volume.mhd"), "HEADER");
    written(folder.file("others/voxels.raw"), "voxels");
    EXPECT_FALSE(findStudy(study, {.folders = {folder.file("others")}, .paths = {}}));
    written(folder.file("own/volume.session.json"), "a session beside it");
    EXPECT_EQ(findStudy(study, {.folders = {folder.file(".")}, .paths = {}}).value_or(""),
              fs::path(folder.file("./own/volume.mhd")).string());

    const std::string first = written(folder.file("more/scan.vol"), "1"),
                      second = written(folder.file("more/scan.v00"), "2"),
                      third = written(folder.file("more/scan.v01"), "3");
    written(folder.file("more/notes.txt"), "of no study");
    const StudyFile three = studyAt(folder.file("gone/scan.vol"), {first, second, third});
    EXPECT_EQ(findStudy(three, {.folders = {folder.file("more")}, .paths = {}}), first);
}

TEST(StudySearch, LooksFourFoldersDeep) {
    const TemporaryFolder folder;
    const std::string file = written(folder.file("1/2/3/4/scan"), "bytes");
    const StudyFile study = studyAt("/nowhere/scan", {file});
    EXPECT_EQ(findStudy(study, {.folders = {folder.file(".")}, .paths = {}}).has_value(), true);
    const std::string deeper = folder.file("1/2/3/4/5/scan");
    fs::create_directories(fs::path(deeper).parent_path());
    fs::rename(file, deeper);
    EXPECT_FALSE(findStudy(study, {.folders = {folder.file(".")}, .paths = {}}));
}

}  // namespace
}  // namespace echolucent
