// The reader's questions about files: the reader asks over the channel, and the workstation answers.
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
    /// `channel` must outlive the object. If the workstation is gone, `ended` is called; it must not return.
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

/// Answers the reader's questions, only for what a person opened.
class FileBroker {
public:
    /// A person opened `path`. Of a folder, all files below it may be seen. Of a file, the file and all below its
    /// folder may be, as a header names the files of its voxels. Links that lead out are refused.
    explicit FileBroker(const std::string& path);
    /// Only these files may be seen.
    explicit FileBroker(const std::vector<std::string>& files);

    /// Writes the bytes of the answer, and the file if one was opened. False if the message is no question or makes no
    /// sense.
    [[nodiscard]] bool answer(const Message& question, const Progress& progress, std::string& bytes, Descriptor& file);
    /// The bytes of all files opened so far; a file opened twice counts once.
    [[nodiscard]] std::uint64_t openedBytes() const { return m_openedBytes; }
    /// The names, as the reader spelt them, of the files that it asked for and that it may see or name. If the reader
    /// claims to have read or listed another file, it made that up.
    [[nodiscard]] const std::set<std::string>& asked() const { return m_asked; }

private:
    /// Whether the reader may see the file at a path without links.
    [[nodiscard]] bool allows(const std::string& resolved) const;
    /// Whether the reader may name `path`: it may name a link out of the folder, but not open it.
    [[nodiscard]] bool allowsName(const std::string& path) const;
    void open(const std::string& path, std::string& bytes, Descriptor& file);

    std::vector<std::string> m_allowed;  // paths without links, in rising order
    std::string m_folder;                // without links; empty if there is none
    std::set<std::string> m_opened, m_asked;
    std::uint64_t m_openedBytes = 0;
};

}  // namespace echolucent::restricted
