// The frames of a DICOM data set as grey values, decoded and reduced to luma one after the other.
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
    /// What any slice of the series needs, so that all slices get one type.
    struct OfSeries {
        bool rescaled = false;  ///< whether grey values are rescaled
        bool padded = false;    ///< whether pixels may hold DicomPixelFormat::padding
    };

    /// Checks everything that the data set says about its pixels against what is there, before memory is taken for
    /// them. Fails (unreadable, naming `path` and the tag) if the two disagree, or if the pixels cannot be read.
    /// All grey values are float32 if a shown frame is rescaled or padding is stated, or if `series` says so.
    [[nodiscard]] static Result<DicomFrames> open(DcmDataset& dataset, const std::string& path, const DicomScan& scan,
                                                  OfSeries series);
    [[nodiscard]] static Result<DicomFrames> open(DcmDataset& dataset, const std::string& path, const DicomScan& scan) {
        return open(dataset, path, scan, {});
    }
    DicomFrames(DicomFrames&&) noexcept;
    ~DicomFrames();

    /// Names the frames that are shown (counted from 0, at least one), in their order. Only these count for type, white
    /// level, window, rescaling and warnings. Before this call all frames are shown.
    void keep(std::vector<std::size_t> shown);

    /// Checks every shown frame while it is compressed, before memory is taken for all of them. The frame's header must
    /// agree with the data set, all its parts must be there, and its bytes must be enough to hold it. Frames that are
    /// not compressed always pass. Fails (unreadable) naming the frame; (cancelled) if the person ended it.
    [[nodiscard]] Result<void> check(const Progress& progress) const;

    [[nodiscard]] std::int64_t columns() const;
    [[nodiscard]] std::int64_t rows() const;
    [[nodiscard]] std::int64_t frames() const;
    /// Of the grey values: uint8, int8, uint16 or int16; float32 if rescaled, or if padding is stated.
    [[nodiscard]] StoredType type() const;
    [[nodiscard]] int bitsStored() const;
    [[nodiscard]] std::int64_t frameBytes() const;  ///< rows * columns * bytes of type()
    [[nodiscard]] double largestValue() const;  ///< the largest value that the stored bits of the shown frames can mean
    /// Sets the window of `parts`. If 8 bits or fewer are stored, or if there is a palette, it also sets the white
    /// level and its source: white is largestValue(), unless that is 0 or less. Files of more bits mostly use a small
    /// part of them and may declare a window, so their white level stays unset.
    void sayWhite(StudyParts& parts) const;
    /// Facts on the pixels for the import report: transfer syntax, photometric interpretation, rescaling, segments of a
    /// palette.
    [[nodiscard]] std::vector<ImportFact> facts() const;
    [[nodiscard]] std::vector<std::string> warnings() const;

    /// Decodes frame `index` (from 0) into grey values in this machine's byte order; out.size() == frameBytes(). Pixels
    /// that hold padding become NaN, and warnings() says so from then on.
    [[nodiscard]] Result<void> readGrey(std::int64_t index, std::span<std::uint8_t> out);

private:
    struct State;
    explicit DicomFrames(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// Widens white and lowest level of `parts` to those of other pictures of the same study, as sayWhite() put them into
/// `said`: differently rescaled pictures reach different values. No lowest level means 0. Nothing changes if one of the
/// two has no white level.
void widenLevels(StudyParts& parts, const StudyParts& said);

}  // namespace echolucent
