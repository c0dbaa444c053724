// The frames of an object as grey values, whether it stands in one file or in several (a concatenation).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/pixels/dicom_pixels.h"
#include "io/study/study_assembly.h"
#include "io/voxels/voxel_types.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The frames of all parts, counted from 0 through all of them.
class FramesOfParts {
public:
    /// The frames of one file, which must outlive this object. Fails as DicomFrames::open() does.
    [[nodiscard]] static Result<FramesOfParts> open(const DicomFile& file);
    /// The frames of the files at `paths`, in this order. Fails too if a file cannot be read, or if its pixels are of
    /// another size or type than those of the first; (cancelled) if the person ended it.
    [[nodiscard]] static Result<FramesOfParts> open(const std::vector<std::string>& paths, const Progress& progress);

    /// As DicomFrames::keep(). Of several parts all frames count: one that is not shown may make the values floats.
    void keep(std::vector<std::size_t> shown);
    /// As DicomFrames::check().
    [[nodiscard]] Result<void> check(const Progress& progress) const;

    [[nodiscard]] std::int64_t columns() const { return m_parts.front().frames.columns(); }
    [[nodiscard]] std::int64_t rows() const { return m_parts.front().frames.rows(); }
    [[nodiscard]] std::int64_t frames() const;
    [[nodiscard]] StoredType type() const { return m_parts.front().frames.type(); }
    /// As DicomFrames::sayWhite(). White is the largest and the lowest level the smallest of all parts; the window is
    /// that of the first part with one.
    void sayWhite(StudyParts& parts) const;
    /// Of the first part, and other transfer syntaxes of the others.
    [[nodiscard]] std::vector<ImportFact> facts() const;
    [[nodiscard]] std::vector<std::string> warnings() const;  ///< of all parts, each once

    /// As DicomFrames::readGrey().
    [[nodiscard]] Result<void> readGrey(std::int64_t index, std::span<std::uint8_t> out);

private:
    struct Part {
        std::shared_ptr<const DicomFile> file;  ///< null if it belongs to somebody else
        DicomFrames frames;
        std::int64_t first = 0;  ///< number of its first frame
    };
    explicit FramesOfParts(std::vector<Part> parts) : m_parts(std::move(parts)) {}

    std::vector<Part> m_parts;
};

}  // namespace echolucent
