// The two ends of a reader's questions about files: it asks over the channel, and the workstation answers.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "io/files/file_access.h"
#include "io/restricted/channel.h"

namespace echolucent::restricted {

/// The file system as the reader process sees it: every question goes to the workstation.
class RemoteFileAccess : public FileAccess {
public:
    /// The channel must outlive this. `ended` is called where the workstation is gone, and does not come back.
    RemoteFileAccess(Channel& channel, void (*ended)()) : m_channel(channel), m_ended(ended) {}

    [[nodiscard]] Result<int> open(const std::string& path) override;
    [[nodiscard]] FileKind kindOf(const std::string& path) override;
    [[nodiscard]] std::string resolved(const std::string& path) override;
    [[nodiscard]] FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) override;

private:
    /// Sends a question and waits for its answer.
    [[nodiscard]] Message ask(MessageKind kind, const std::string& bytes);

    Channel& m_channel;
    void (*m_ended)();
    std::mutex m_asking;
};

/// Answers these questions for what a person opened, and for nothing else.
class FileBroker {
public:
    /// A person opened `path`. Where it is a folder, all below it is answered for, where it is a file, it and all below
    /// the folder that it lies in: a header names the files of its voxels. Links that lead out of it are refused.
    explicit FileBroker(const std::string& path);
    /// These files and no others are answered for.
    explicit FileBroker(const std::vector<std::string>& files);

    /// What a question comes to: the bytes of the answer and, where a file was opened, that file. False where it is
    /// none.
    [[nodiscard]] bool answer(const Message& question, const Progress& progress, std::string& bytes, Descriptor& file);
    /// How many bytes the files opened so far have together; a file that was opened twice counts once.
    [[nodiscard]] std::uint64_t openedBytes() const { return m_openedBytes; }
    /// The names, as the reader spelt them, of the files that it asked for and may see, or may speak of. What it names
    /// as read or listed is among them, or was made up.
    [[nodiscard]] const std::set<std::string>& asked() const { return m_asked; }

private:
    /// Whether what a path leads to, without links, may be seen.
    [[nodiscard]] bool allows(const std::string& resolved) const;
    /// Whether a name lies where what it leads to could be seen: a link out of the folder may be spoken of, not opened.
    [[nodiscard]] bool allowsName(const std::string& path) const;
    void open(const std::string& path, std::string& bytes, Descriptor& file);

    std::vector<std::string> m_allowed;  // paths without links, in rising order
    std::string m_folder;                // without links; empty where there is none
    std::set<std::string> m_opened, m_asked;
    std::uint64_t m_openedBytes = 0;
};

}  // namespace echolucent::restricted
