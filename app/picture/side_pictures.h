// The small pictures of the six sides. A thread makes them.
#pragma once

#include <QImage>
#include <QObject>
#include <array>
#include <memory>
#include <optional>
#include <tuple>

#include "app/study/study_sides.h"
#include "processing/document/document.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class VolumeViewWidget;

/// Makes a picture of each side while somebody sees them, from raw voxels, with the look and the curve of the document.
/// The first ones are made as soon as the 3D view shows the study. Later ones are made at rest, if sides, look or curve
/// are others, and give way to other work.
class SidePictures : public QObject {
    Q_OBJECT

public:
    /// Pixels of a picture.
    static constexpr int width = 208, height = 136;
    using Images = std::array<QImage, std::tuple_size_v<Sides>>;

    /// What the parameters refer to must outlive this object.
    SidePictures(const DocumentModel& model, const StudySides& sides, const VolumeViewWidget& picture, Works& works,
                 QObject* parent = nullptr);

    /// Sets whether somebody sees the pictures; at first nobody does.
    void setSeen(bool seen);
    /// Ends what is being made, because another study was asked for. If it does not come, makes it at rest.
    void stop();
    /// A picture is null until it is made.
    [[nodiscard]] const Images& images() const { return m_images; }

signals:
    void changed();

private:
    /// All that the pictures depend on.
    struct Asked {
        std::shared_ptr<const SidesFinding> sides;
        Document document;
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    void follow();
    [[nodiscard]] std::optional<Asked> wanted() const;

    const DocumentModel& m_model;
    const StudySides& m_sides;
    Works& m_works;
    bool m_seen = false;
    bool m_shown = false;                    ///< the 3D view shows the study whose sides they are
    std::shared_ptr<const Volume> m_volume;  ///< the phase whose sides they are
    std::optional<Asked> m_asked;            ///< of the pictures, or of those being made
    Images m_images;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
