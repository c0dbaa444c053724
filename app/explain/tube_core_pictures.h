// The small pictures of the panel *Tube cores*: the scene under three curves.
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "app/otf/pane_otfs.h"
#include "app/study/open_study.h"
#include "processing/pane_picture/pane_caster.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"
#include "widgets/tube_cores/shown_explanation.h"
#include "widgets/tube_cores/tube_core_panel.h"

namespace echolucent {

/// What pictures of the scene under curves of its adaptive OTF are made from. They show what PaneCaster shows of the
/// first pane of `document`.
struct CurvePictureSource {
    Document document{};   ///< with only what such pictures depend on
    StudyPhases voxels{};  ///< the phase shown, uncut, and its quiet voxels if they are made
    friend bool operator==(const CurvePictureSource&, const CurvePictureSource&) = default;
};
/// Empty if no study is open.
[[nodiscard]] std::optional<CurvePictureSource> curvePictureSource(const Document& document,
                                                                   const OpenStudy& openStudy);

/// Makes the pictures one after the other while a person sees the panel and no other work is under way, as
/// PresetPictures does. Makes none while the document asks for a newer OTF than the one explained: the pictures before
/// stay. While they are seen, keeps its own ray caster (RayCaster tells its size).
class TubeCorePictures : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    TubeCorePictures(DocumentModel& model, OpenStudy& openStudy, Works& works, const PaneOtfs& otfs,
                     TubeCorePanel& panel, QObject* parent = nullptr);

    /// Whether a person sees the pictures; at first nobody does.
    void setSeen(bool seen);
    /// Null: there are no pictures.
    void setExplanation(std::shared_ptr<const ShownExplanation> explanation);

private:
    /// All that a picture depends on.
    struct Asked {
        CurvePictureSource source;
        SampledCurve curve;
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    void follow();
    void makeNext();
    void drop();
    [[nodiscard]] std::optional<int> next() const;
    [[nodiscard]] std::optional<Asked> askedOf(int which) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Works& m_works;
    const PaneOtfs& m_otfs;
    TubeCorePanel& m_panel;
    bool m_seen = false;
    std::shared_ptr<const ShownExplanation> m_explanation;
    std::array<std::optional<Asked>, TubeCorePanel::pictures> m_wanted, m_made;
    std::optional<int> m_making;
    Works::UnderWay m_work;                ///< from a change of a seen picture until it is made
    std::shared_ptr<PaneCaster> m_caster;  ///< only the thread uses it; null while nobody sees the pictures
    StudyPhases m_cast;                    ///< what m_caster casts through
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
