// Enhanced US Volumes for the reader: small volumes, and written objects that a test changes.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/writers/enhanced_us_writer.h"
#include "processing/volume/volume.h"

class DcmDataset;
class DcmItem;
class DcmTagKey;

namespace echolucent {

using SharedPhases = std::vector<std::shared_ptr<const Volume>>;

/// The phases of a small simulated scan of `bits` (8 or 16) bits with this geometry, which has at least 8 voxels along
/// each axis.
[[nodiscard]] SharedPhases simulatedPhases(const VolumeGeometry& geometry, int bits, int phases);

/// A geometry of 9 x 11 x 8 voxels of different edges, turned against the patient, with an origin of its own.
[[nodiscard]] VolumeGeometry obliqueGeometry();

/// A written object that is opened again, changed and saved.
class EnhancedUsFile {
public:
    /// Throws std::runtime_error if DCMTK cannot read the file.
    explicit EnhancedUsFile(std::string path);
    ~EnhancedUsFile();
    EnhancedUsFile(const EnhancedUsFile&) = delete;
    EnhancedUsFile& operator=(const EnhancedUsFile&) = delete;

    [[nodiscard]] DcmDataset& dataset() const;
    /// A functional group's item: of one frame (counted from 0) and made if missing, or of all frames.
    [[nodiscard]] DcmItem& groupOfFrame(std::size_t frame, const DcmTagKey& group) const;
    [[nodiscard]] DcmItem& groupOfAll(const DcmTagKey& group) const;
    /// Sets the Dimension Index Values of a frame.
    void setIndexValues(std::size_t frame, const std::vector<unsigned>& values) const;
    /// Reorders the frames with their pixels: place i gets what stood at order[i].
    void reorderFrames(const std::vector<std::size_t>& order) const;
    [[nodiscard]] std::size_t frames() const;
    void save() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
