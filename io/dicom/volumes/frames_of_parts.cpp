#include "io/dicom/volumes/frames_of_parts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>

namespace echolucent {

Result<FramesOfParts> FramesOfParts::open(const DicomFile& file) {
    auto frames = DicomFrames::open(file.dataset(), file.path(), file.scan());
    if (!frames) return tl::unexpected(frames.error());
    std::vector<Part> parts;
    parts.push_back({nullptr, std::move(*frames), 0});
    return FramesOfParts(std::move(parts));
}

Result<FramesOfParts> FramesOfParts::open(const std::vector<std::string>& paths, const Progress& progress) {
    std::vector<Part> parts;
    std::int64_t first = 0;
    // If the frames of one part are rescaled, those of all must become floats.
    bool rescaled = false, differ = false;
    const auto take = [&](std::shared_ptr<const DicomFile> file) -> Result<void> {
        auto frames =
            DicomFrames::open(file->dataset(), file->path(), file->scan(), {.rescaled = rescaled, .padded = false});
        if (!frames) return tl::unexpected(frames.error());
        parts.push_back({std::move(file), std::move(*frames), first});
        first += parts.back().frames.frames();
        differ = differ || parts.back().frames.type() != parts.front().frames.type();
        return {};
    };
    for (const std::string& path : paths) {
        auto file = DicomFile::load(path, false, progress);
        if (!file) return tl::unexpected(file.error());
        if (auto taken = take(std::make_shared<const DicomFile>(std::move(*file))); !taken)
            return tl::unexpected(taken.error());
    }
    if (differ) {
        std::vector<Part> before = std::move(parts);
        parts.clear();
        first = 0;
        rescaled =
            std::ranges::any_of(before, [](const Part& part) { return part.frames.type() == StoredType::float32; });
        differ = false;
        for (Part& part : before)
            if (auto taken = take(std::move(part.file)); !taken) return tl::unexpected(taken.error());
    }
    const auto other = std::ranges::find_if(parts, [&](const Part& part) {
        const DicomFrames& one = part.frames;
        const DicomFrames& wanted = parts.front().frames;
        return one.columns() != wanted.columns() || one.rows() != wanted.rows() || one.type() != wanted.type();
    });
    if (other != parts.end())
        return fail(FailureKind::unreadable, other->file->path(), "(0028,0100) Bits Allocated, (0028,0010) Rows",
                    "makes the pixels of this part of an object another size or type than those of the first part",
                    "Export the object again.");
    return FramesOfParts(std::move(parts));
}

void FramesOfParts::keep(std::vector<std::size_t> shown) {
    if (m_parts.size() == 1) m_parts.front().frames.keep(std::move(shown));
}

Result<void> FramesOfParts::check(const Progress& progress) const {
    for (const Part& part : m_parts)
        if (auto checked = part.frames.check(progress); !checked) return checked;
    return {};
}

std::int64_t FramesOfParts::frames() const { return m_parts.back().first + m_parts.back().frames.frames(); }

void FramesOfParts::sayWhite(StudyParts& parts) const {
    m_parts.front().frames.sayWhite(parts);
    for (const Part& part : m_parts) {
        StudyParts said;
        part.frames.sayWhite(said);
        if (!parts.window) parts.window = std::move(said.window);
        widenLevels(parts, said);
    }
}

std::vector<ImportFact> FramesOfParts::facts() const {
    std::vector<ImportFact> facts = m_parts.front().frames.facts();
    for (const Part& part : m_parts)
        for (const ImportFact& fact : part.frames.facts()) {
            const auto same = std::ranges::find(facts, fact.name, &ImportFact::name);
            if (same == facts.end())
                facts.push_back(fact);
            else if (fact.name == "transfer syntax" && same->value.find(fact.value) == std::string::npos)
                same->value += ", " + fact.value;
        }
    return facts;
}

std::vector<std::string> FramesOfParts::warnings() const {
    std::vector<std::string> sentences;
    for (const Part& part : m_parts)
        for (std::string& sentence : part.frames.warnings())
            if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(std::move(sentence));
    return sentences;
}

Result<void> FramesOfParts::readGrey(std::int64_t index, std::span<std::uint8_t> out) {
    const auto behind = std::ranges::upper_bound(m_parts, index, {}, &Part::first);
    Part& part = *std::prev(behind);
    return part.frames.readGrey(index - part.first, out);
}

}  // namespace echolucent
