#include "io/restricted/remote_files.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "io/restricted/descriptions.h"

namespace echolucent::restricted {

namespace {

std::span<const std::uint8_t> bytesOf(const Message& message) {
    return {reinterpret_cast<const std::uint8_t*>(message.bytes.data()), message.bytes.size()};
}

bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

Message RemoteFileAccess::ask(MessageKind kind, const std::string& bytes) {
    const std::lock_guard alone(m_asking);
    Message answer;
    if (!m_channel.send(kind, bytes) ||
        m_channel.receive(answer, std::chrono::milliseconds(-1)) != Channel::Wait::arrived)
        m_ended();
    return answer;
}

Result<int> RemoteFileAccess::open(const std::string& path) {
    Message answer = ask(MessageKind::openFile, messageOf(path));
    std::optional<Failure> failure;
    MessageReader reader(bytesOf(answer));
    reader(failure);
    if (failure) return tl::unexpected(*failure);
    if (answer.files.empty()) m_ended();
    return answer.files.front().release();
}

FileKind RemoteFileAccess::kindOf(const std::string& path) {
    const Message answer = ask(MessageKind::fileKind, messageOf(path));
    FileKind kind = FileKind::missing;
    MessageReader(bytesOf(answer)).choice(kind, FileKind::other);
    return kind;
}

std::string RemoteFileAccess::resolved(const std::string& path) {
    const Message answer = ask(MessageKind::resolvePath, messageOf(path));
    std::string end;
    MessageReader reader(bytesOf(answer));
    reader(end);
    return end;
}

FilesBelow RemoteFileAccess::filesBelow(const std::string& folder, int deepest, const Progress&) {
    const Message answer = ask(MessageKind::listFolder, messageOf(folder, deepest));
    FilesBelow below;
    MessageReader reader(bytesOf(answer));
    reader(below);
    return below;
}

FileBroker::FileBroker(const std::string& path) {
    FileAccess& files = fileAccess();
    const bool isFolder = files.kindOf(path) == FileKind::folder;
    const std::string folder = isFolder ? path : std::filesystem::path(path).parent_path().string();
    m_folder = files.resolved(folder.empty() ? "." : folder);
    m_allowed = {files.resolved(path)};
}

FileBroker::FileBroker(const std::vector<std::string>& files) {
    for (const std::string& file : files) m_allowed.push_back(fileAccess().resolved(file));
    std::sort(m_allowed.begin(), m_allowed.end());
}

bool FileBroker::allows(const std::string& resolved) const {
    if (std::binary_search(m_allowed.begin(), m_allowed.end(), resolved)) return true;
    return !m_folder.empty() && liesBelow(resolved, m_folder);
}

bool FileBroker::allowsName(const std::string& path) const {
    const std::filesystem::path name(path);
    const std::filesystem::path folder = fileAccess().resolved(name.parent_path().string());
    return allows(fileAccess().resolved(path)) || allows((folder / name.filename()).string());
}

void FileBroker::open(const std::string& path, std::string& bytes, Descriptor& file) {
    const std::string resolved = fileAccess().resolved(path);
    const bool allowed = allows(resolved);
    // The list of series also names links out of the folder, among the files that cannot be opened.
    if (allowed || allowsName(path)) m_asked.insert(path);
    Result<int> opened = !allowed ? fail(FailureKind::unreadable, path, "", "leads out of the folder that was opened",
                                         "Copy the file itself into that folder.")
                                  : fileAccess().open(path);
    if (!opened) {
        bytes = messageOf(std::optional(opened.error()));
        return;
    }
    Descriptor descriptor(*opened);
    struct stat status {};
    if (fstat(descriptor.number(), &status) != 0 || !S_ISREG(status.st_mode)) {
        bytes = messageOf(std::optional(
            fail(FailureKind::unreadable, path, "", "is not a file that can be read", "Check the name.").value()));
        return;
    }
    if (m_opened.insert(resolved).second) m_openedBytes += static_cast<std::uint64_t>(status.st_size);
    file = std::move(descriptor);
    bytes = messageOf(std::optional<Failure>());
}

bool FileBroker::answer(const Message& question, const Progress& progress, std::string& bytes, Descriptor& file) {
    MessageReader reader(bytesOf(question));
    std::string path;
    reader(path);
    int deepest = 0;
    if (question.kind == MessageKind::listFolder) reader(deepest);
    if (!reader.complete() || path.find('\0') != std::string::npos) return false;
    FileAccess& files = fileAccess();
    switch (question.kind) {
        case MessageKind::openFile: open(path, bytes, file); return true;
        case MessageKind::fileKind: {
            const bool allowed = allowsName(path);
            if (allowed) m_asked.insert(path);
            const FileKind kind = allowed ? files.kindOf(path) : FileKind::missing;
            MessageWriter writer;
            writer.choice(kind, FileKind::other);
            bytes = writer.bytes();
            return true;
        }
        case MessageKind::resolvePath: bytes = messageOf(files.resolved(path)); return true;
        case MessageKind::listFolder: {
            const bool allowed = !m_folder.empty() && allows(files.resolved(path));
            bytes = messageOf(allowed ? files.filesBelow(path, std::clamp(deepest, 0, 64), progress) : FilesBelow{});
            return true;
        }
        default: return false;
    }
}

}  // namespace echolucent::restricted
