#include "processing/document/study_reference.h"

namespace echolucent {

std::optional<GridAxis> turnedAxisOf(const StudyReference& study) {
    const auto* file = std::get_if<StudyFile>(&study);
    return file != nullptr ? file->turnedAxis : std::nullopt;
}

bool nameTheSame(const StudyReference& one, const StudyReference& other) {
    const auto* file = std::get_if<StudyFile>(&one);
    const auto* otherFile = std::get_if<StudyFile>(&other);
    if (file == nullptr || otherFile == nullptr) return one == other;
    return file->path == otherFile->path && file->options == otherFile->options;
}

}  // namespace echolucent
