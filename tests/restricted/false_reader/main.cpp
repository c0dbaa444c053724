// A reader process that does not do what a reader does: it says nothing, or rubbish, or what would do harm. Which of
// it, the environment says, because the workstation gives it no words of its own.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <string>

#include "io/restricted/channel.h"
#include "io/restricted/descriptions.h"
#include "io/restricted/shared_study.h"

namespace {

using namespace echolucent;
using namespace echolucent::restricted;

std::string saying(bool filtered) {
    MessageWriter writer;
    writer(filtered);
    return writer.bytes();
}

std::string randomBytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::string bytes(count, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
}

Study smallStudy() {
    Study study;
    study.name = "false";
    VolumeGeometry geometry;
    geometry.size = {4, 4, 4};
    geometry.reduction = Reduction{{2, 2, 2}, {8, 8, 7}};
    study.phases = {std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>(64, 7))};
    return study;
}

/// Words that clear a terminal, turn the direction of writing, begin a line, and are no UTF-8.
std::string badWords() { return "a\x1b[2J\u009b2J\u202eb\u2066\u2028c\r\nd\xff\xc0\x80\xed\xa0\x80"; }

/// The message of a study that was read, as a reader sends it.
std::string withoutFailure(const std::string& study) {
    MessageWriter writer;
    writer(std::optional<Failure>());
    return writer.bytes() + study;
}

/// What a coarse grid shows, and what becomes of it afterwards.
void lieCoarsely(Channel& channel, const std::string& mode, unsigned seed) {
    auto voxels = smallStudy().phases.front();
    if (mode == "coarse-too-long") {
        VolumeGeometry geometry;
        geometry.size = {1, 1, mostCoarseVoxels + 1};
        voxels = std::make_shared<const Volume>(
            geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(mostCoarseVoxels + 1), 7));
    }
    auto shared = shareCoarse({voxels, 4.0});
    const auto sendCoarse = [&](const std::string& bytes, int memory) {
        static_cast<void>(channel.send(MessageKind::coarse, bytes, {memory}));
    };
    const auto sendResult = [&] {
        SharedVoxelMemory memory;
        const auto study = shareStudy(smallStudy(), memory);
        static_cast<void>(channel.send(MessageKind::result, withoutFailure(study->bytes), {study->voxels.number()}));
    };
    if (mode == "coarse-mutated") {
        std::mt19937 random(seed);
        for (unsigned change = 0; change <= seed % 8; ++change)
            shared->bytes[random() % shared->bytes.size()] = static_cast<char>(random());
        sendCoarse(shared->bytes, shared->voxels.number());
    } else if (mode == "coarse-rubbish") {
        sendCoarse(randomBytes(seed % 4096, seed), shared->voxels.number());
    } else if (mode == "coarse-without-memory") {
        static_cast<void>(channel.send(MessageKind::coarse, shared->bytes));
    } else if (mode == "coarse-too-large") {
        sendCoarse(shared->bytes, sharedMemory(std::uint64_t{1} << 30).number());
    } else if (mode == "coarse-still-written") {
        // It would change the voxels while they are looked at.
        static_cast<void>(mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, shared->voxels.number(), 0));
        sendCoarse(shared->bytes, shared->voxels.number());
    } else {
        sendCoarse(shared->bytes, shared->voxels.number());
        if (mode == "coarse-twice") {
            const auto second = shareCoarse({smallStudy().phases.front(), 4.0});
            sendCoarse(second->bytes, second->voxels.number());
        }
    }
    if (mode == "coarse-fails") {
        // Not before whoever looks on has looked: until then nobody has opened the pipe for writing.
        if (const char* const pipe = std::getenv("ECHOLUCENT_FALSE_PIPE"); pipe != nullptr)
            close(open(pipe, O_RDONLY | O_CLOEXEC));
        MessageWriter report;
        report(std::optional(fail(FailureKind::unreadable, "a.mha", "", "ends within its voxels").value()));
        static_cast<void>(channel.send(MessageKind::result, report.bytes()));
    } else if (mode != "coarse-stays") {
        sendResult();
    }
    if (mode == "coarse-after-result") sendCoarse(shared->bytes, shared->voxels.number());
}

/// Says something false, seed by seed.
void lie(Channel& channel, const std::string& mode, unsigned seed) {
    if (mode == "unconfined") {
        MessageWriter writer;
        writer(std::string("/etc/hostname"));
        static_cast<void>(channel.send(MessageKind::openFile, writer.bytes()));
        return;
    }
    static_cast<void>(channel.send(MessageKind::confined, saying(true)));
    if (mode.starts_with("coarse")) return lieCoarsely(channel, mode, seed);
    SharedVoxelMemory memory;
    auto shared = shareStudy(smallStudy(), memory);
    const auto sendStudy = [&](const std::string& bytes, int voxels) {
        static_cast<void>(channel.send(MessageKind::result, withoutFailure(bytes), {voxels}));
    };
    if (mode == "rubbish")
        static_cast<void>(channel.send(MessageKind::result, randomBytes(seed % 4096, seed)));
    else if (mode == "mutated") {
        std::string bytes = shared->bytes;
        std::mt19937 random(seed);
        for (unsigned change = 0; change <= seed % 8; ++change)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        sendStudy(bytes, shared->voxels.number());
    } else if (mode == "short-memory")
        sendStudy(shared->bytes, sharedMemory(16).number());
    else if (mode == "no-memory")
        static_cast<void>(channel.send(MessageKind::result, withoutFailure(shared->bytes)));
    else if (mode == "a-file-for-memory")
        sendStudy(shared->bytes, open("/etc/hostname", O_RDONLY | O_CLOEXEC));
    else if (mode == "endless-progress")
        while (channel.send(MessageKind::progress, std::string(8, '\0'))) {
        }
    else if (mode == "outside") {
        // What the answer holds comes back as the sentence.
        MessageWriter writer;
        writer(std::string("/etc/hostname"));
        static_cast<void>(channel.send(MessageKind::openFile, writer.bytes()));
        Message answer;
        static_cast<void>(channel.receive(answer, std::chrono::milliseconds(-1)));
        MessageWriter report;
        report(std::optional(
            fail(FailureKind::unreadable, "", "", answer.files.empty() ? "was refused" : "WAS OPENED").value()));
        static_cast<void>(channel.send(MessageKind::result, report.bytes()));
    } else if (mode == "bad-words") {
        Study study = smallStudy();
        study.name = badWords();
        study.facts = {{badWords(), badWords(), badWords()}};
        study.warnings.assign(5000, badWords() + std::string(3000, 'x'));
        const auto spoken = shareStudy(study, memory);
        sendStudy(spoken->bytes, spoken->voxels.number());
    } else if (mode == "left-handed") {
        VolumeGeometry mirrored = smallStudy().phases.front()->geometry();
        mirrored.direction = Mat3::diag({1, 1, -1});
        Study study;
        study.name = "false";
        study.phases = {std::make_shared<const Volume>(mirrored, std::vector<std::uint8_t>(64, 7))};
        const auto shown = shareStudy(study, memory);
        sendStudy(shown->bytes, shown->voxels.number());
    } else if (mode == "refuses-with-bad-words") {
        MessageWriter report;
        report(std::optional(
            fail(FailureKind::unreadable, badWords(), badWords(), badWords() + std::string(100000, 'x'), badWords())
                .value()));
        static_cast<void>(channel.send(MessageKind::result, report.bytes()));
    } else if (mode == "names-another-file") {
        Study study = smallStudy();
        study.files = {"/etc/hostname"};
        const auto named = shareStudy(study, memory);
        sendStudy(named->bytes, named->voxels.number());
    } else if (mode.starts_with("lists-")) {
        const std::string folder = std::getenv("ECHOLUCENT_FALSE_FOLDER");
        const std::string file = mode == "lists-a-file-beside" ? "/etc/hostname" : folder + "/a.mha";
        MessageWriter question;
        question(file);
        Message answer;
        if (mode != "lists-what-it-did-not-ask-for" && channel.send(MessageKind::fileKind, question.bytes()))
            static_cast<void>(channel.receive(answer, std::chrono::milliseconds(-1)));
        SeriesEntry entry;
        entry.files.emplace_back().path = file;
        MessageWriter list;
        list(std::optional<Failure>(), std::optional(SeriesList{folder, {entry}, {file}, {}}));
        static_cast<void>(channel.send(MessageKind::result, list.bytes()));
    } else if (mode == "honest")
        sendStudy(shared->bytes, shared->voxels.number());
}

}  // namespace

int main() {
    const char* const mode = std::getenv("ECHOLUCENT_FALSE_READER");
    const char* const seed = std::getenv("ECHOLUCENT_FALSE_SEED");
    const std::string wanted = mode != nullptr ? mode : "nothing";
    if (wanted == "ends-at-once") return 0;
    Channel channel{Descriptor(3)};
    if (wanted == "raw-bytes") {
        const std::string bytes = randomBytes(1000, seed != nullptr ? static_cast<unsigned>(std::atoi(seed)) : 1);
        return write(3, bytes.data(), bytes.size()) > 0 ? 0 : 1;
    }
    Message request;
    if (channel.receive(request, std::chrono::milliseconds(-1)) != Channel::Wait::arrived) return 0;
    if (wanted == "crashes") {
        std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would end it in another way
        std::raise(SIGSEGV);
    }
    if (wanted == "too-long") std::raise(SIGXCPU);
    if (wanted != "silent") lie(channel, wanted, seed != nullptr ? static_cast<unsigned>(std::atoi(seed)) : 1);
    // It stays until it is ended, as one would that hopes to change what it has sent.
    while (true) pause();
}
