// Shows in the curve editor at which intensities the first pane holds light back early.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/otf/kept_surfaces.h"
#include "app/otf/shown_panes.h"
#include "processing/comparison/early_light.h"
#include "processing/pane_picture/pane_measures.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class MessageBar;
class OtfEditor;

/// Measures earlyLightOf() the first pane in the background, while a person has switched it on and sees the editor. The
/// view, the voxels and the classification are those that the pane shows. While a hand drags or a motion plays, and
/// until the newest is measured, the editor shows none.
class EditorEarlyLight : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        const ShownPanes& panes;
        OtfEditor& editor;
        MessageBar& messages;
        KeptSurfaces& surfaces;
    };
    /// What the parameters refer to must outlive this object.
    explicit EditorEarlyLight(const Parts& parts, QObject* parent = nullptr);

    /// Whether a person sees the editor. Not at first.
    void setSeen(bool seen);

private:
    struct Asked {
        SurfaceSource source{};
        std::shared_ptr<const Volume> raw, shown;
        Classification classification{};
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    struct Measured {
        Asked asked;
        EarlyLight light;
    };
    [[nodiscard]] std::optional<Asked> wanted() const;
    void follow();
    void measure(const Asked& asked);
    void forgetStudy();

    Parts m_parts;
    bool m_seen = false;
    std::optional<Asked> m_asked;        ///< the newest request
    std::optional<Measured> m_measured;  ///< what was measured last
    NewestWinsThread m_thread;           ///< last, so that it has ended before anything above is destroyed
};

}  // namespace echolucent
