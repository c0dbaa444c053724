// The small pictures of presets: each shows the open study with a preset. A thread makes them.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/study/open_study.h"
#include "processing/document/preset.h"
#include "processing/pane_picture/pane_caster.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Makes pictures one after the other while somebody sees them and no other work is under way. Makes a picture again
/// only if something it depends on has changed. If other work begins, drops the picture being made. While the pictures
/// are seen, keeps its own ray caster (RayCaster tells its size).
class PresetPictures : public QObject {
    Q_OBJECT

public:
    /// Pixels of a picture.
    static constexpr int width = 184, height = 138;

    /// What the parameters refer to must outlive this object.
    PresetPictures(DocumentModel& model, OpenStudy& openStudy, Works& works, QObject* parent = nullptr);

    /// Keeps the pictures of presets that were there before.
    void setPresets(std::vector<Preset> presets);
    /// Sets whether somebody sees the pictures; at first nobody does.
    void setSeen(bool seen);

    /// Null until it is made.
    [[nodiscard]] QImage picture(int index) const;

signals:
    /// The picture of a preset has changed.
    void made(int index);

private:
    /// All that a picture depends on.
    struct Asked {
        Document document;
        StudyPhases voxels;  ///< the phase shown, uncut, and its quiet voxels if they are made
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    struct Entry {
        Preset preset;
        std::optional<Asked> wanted;  ///< no value if no study is open or nobody sees the pictures
        std::optional<Asked> made;    ///< what the picture shows
        QImage picture;
    };

    void follow();
    void followRest();
    void makeNext();
    void drop();
    [[nodiscard]] std::optional<Asked> askedOf(const Preset& preset) const;
    [[nodiscard]] int next() const;
    void take(const Asked& asked, const QImage& picture);

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Works& m_works;
    std::vector<Entry> m_entries;
    bool m_seen = false;
    std::optional<Asked> m_making;
    Works::UnderWay m_wanted;  ///< from a change of a seen picture until it is made
    /// Only the thread uses it; null while nobody sees the pictures.
    std::shared_ptr<PaneCaster> m_caster;
    StudyPhases m_cast;  ///< what m_caster casts through
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
