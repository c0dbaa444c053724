// The frames of a DICOM data set as grey values: decoded, reduced to luma, one after the other.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_scan.h"
#include "io/study/study_assembly.h"
#include "io/voxels/voxel_types.h"
#include "processing/progress.h"

class DcmDataset;

namespace echolucent {

/// The frames of one data set, which must outlive this object.
class DicomFrames {
public:
    /// Checks everything that the data set says about its pixels against what is there, before memory is taken for
    /// them. Fails (unreadable, naming `path` and the tag) where both disagree or cannot be read.
    /// Where the values of a frame that is kept are rescaled, or where `rescaled` says so for a slice among others, all
    /// grey values are float32.
    [[nodiscard]] static Result<DicomFrames> open(DcmDataset& dataset, const std::string& path, const DicomScan& scan,
                                                  bool rescaled = false);
    DicomFrames(DicomFrames&&) noexcept;
    ~DicomFrames();

    /// Names the frames (counted from 0, at least one) that are shown, in their order: only they are asked for type,
    /// white level, window, rescaling and warnings. Until then these are all frames.
    void keep(std::vector<std::size_t> shown);

    /// Looks at every frame that is shown, compressed, before memory is taken for all of them: that its own header
    /// agrees with the data set, that all parts of it are there, and that as few bytes can hold it. Fails (unreadable)
    /// naming the frame; (cancelled) where the person ended it.
    [[nodiscard]] Result<void> check(const Progress& progress) const;

    [[nodiscard]] std::int64_t columns() const;
    [[nodiscard]] std::int64_t rows() const;
    [[nodiscard]] std::int64_t frames() const;
    [[nodiscard]] StoredType type() const;  ///< of the grey values: uint8, int8, uint16 or int16; float32 if rescaled
    [[nodiscard]] int bitsStored() const;
    [[nodiscard]] std::int64_t frameBytes() const;  ///< rows * columns * bytes of type()
    [[nodiscard]] double largestValue() const;      ///< the largest that the stored bits of the frames shown can mean
    /// Sets white level, its source and window of `parts`: where 8 bits or fewer are stored, white is the largest value
    /// that they can hold; files of more bits mostly use a small part of these and may declare a window.
    void sayWhite(StudyParts& parts) const;
    /// What the import report says of the pixels: transfer syntax, photometric interpretation, rescaling.
    [[nodiscard]] std::vector<ImportFact> facts() const;
    [[nodiscard]] std::vector<std::string> warnings() const;

    /// Decodes frame `index` (from 0) into grey values in this machine's byte order; out.size() == frameBytes().
    [[nodiscard]] Result<void> readGrey(std::int64_t index, std::span<std::uint8_t> out);

private:
    struct State;
    explicit DicomFrames(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
