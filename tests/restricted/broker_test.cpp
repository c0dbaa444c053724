// What the workstation lets a reader see of the file system.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "io/files/descriptor.h"
#include "io/restricted/descriptions.h"
#include "io/restricted/remote_files.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using restricted::FileBroker;
using restricted::Message;
using restricted::MessageKind;
using restricted::MessageReader;
using restricted::MessageWriter;

class Broker : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(m_folder.file("study/deep"));
        m_folder.write("study/a.mhd", "header");
        m_folder.write("study/deep/a.raw", "voxels");
        m_folder.write("secret", "other");
        std::filesystem::create_symlink(m_folder.file("secret"), m_folder.file("study/link"));
    }
    /// How many bytes a reader gets of a path; -1 where it is refused.
    long opened(FileBroker& broker, const std::string& path) {
        MessageWriter writer;
        writer(path);
        std::string bytes;
        Descriptor file;
        if (!broker.answer({MessageKind::openFile, writer.bytes(), {}}, {}, bytes, file)) return -2;
        return file ? static_cast<long>(std::filesystem::file_size("/proc/self/fd/" + std::to_string(file.number())))
                    : -1;
    }
    std::string in(const std::string& name) const { return m_folder.file(name); }

private:
    TemporaryFolder m_folder;
};

TEST_F(Broker, GivesTheFileAndWhatLiesBelowItsFolder) {
    FileBroker broker(in("study/a.mhd"));
    EXPECT_EQ(opened(broker, in("study/a.mhd")), 6);
    EXPECT_EQ(opened(broker, in("study/deep/a.raw")), 6);
    EXPECT_EQ(opened(broker, in("study/../study/deep/a.raw")), 6);
    EXPECT_EQ(broker.openedBytes(), 12u) << "a file that is opened twice counts once";
}

TEST_F(Broker, GivesNothingElse) {
    FileBroker broker(in("study/a.mhd"));
    for (const char* name : {"secret", "study/../secret", "study/link", "study"})
        EXPECT_LT(opened(broker, in(name)), 0) << name;
    EXPECT_EQ(opened(broker, "/etc/hostname"), -1);
    EXPECT_EQ(opened(broker, in("study/a.mhd") + std::string(1, '\0')), -2) << "such a path is no question";
    FileBroker listed(std::vector<std::string>{in("study/a.mhd")});
    EXPECT_EQ(opened(listed, in("study/a.mhd")), 6);
    EXPECT_EQ(opened(listed, in("study/deep/a.raw")), -1);
}

TEST_F(Broker, AnswersNothingThatIsNoQuestion) {
    FileBroker broker(in("study/a.mhd"));
    std::string bytes;
    Descriptor file;
    for (const MessageKind kind : {MessageKind::openFile, MessageKind::fileKind, MessageKind::resolvePath,
                                   MessageKind::listFolder, MessageKind::request, MessageKind::answer})
        for (const std::string& question : {std::string(), std::string(8, '\xff'), std::string(3, 'x')})
            EXPECT_FALSE(broker.answer({kind, question, {}}, {}, bytes, file));
}

TEST_F(Broker, ListsItsFolderOnly) {
    FileBroker broker(in("study"));
    const auto listed = [&](const std::string& folder) {
        MessageWriter writer;
        writer(folder, 4);
        std::string bytes;
        Descriptor file;
        EXPECT_TRUE(broker.answer({MessageKind::listFolder, writer.bytes(), {}}, {}, bytes, file));
        FilesBelow below;
        MessageReader reader({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        reader(below);
        EXPECT_TRUE(reader.complete());
        return below.paths.size();
    };
    EXPECT_EQ(listed(in("study")), 2u) << "the link leads out";
    EXPECT_EQ(listed(in("")), 0u);
    EXPECT_EQ(listed("/etc"), 0u);
}

}  // namespace
}  // namespace echolucent
