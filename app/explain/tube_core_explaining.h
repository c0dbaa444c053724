// Explains the chosen tube core in the panel *Tube cores*.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_pictures.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"
#include "widgets/tube_cores/shown_explanation.h"

namespace echolucent {

class MessageBar;
class TubeCorePanel;

/// Explains the tube cores of the scene's adaptive OTF, whatever the picture is rendered with, while a person sees the
/// panel. A newer choice or a newer OTF replaces what is being explained; until the new one is there, the panel shows
/// the one before. The panel's parameters are the document's.
class TubeCoreExplaining : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PaneOtfs& otfs;
        TubeCoreChoice& choice;
        TubeCorePanel& panel;
        MessageBar& messages;
    };
    /// What the parameters refer to must outlive this object.
    explicit TubeCoreExplaining(const Parts& parts, QObject* parent = nullptr);

    /// Whether a person sees the panel. Not at first.
    void setSeen(bool seen);
    /// The explanation that the panel shows; null if it shows none.
    [[nodiscard]] const std::shared_ptr<const ShownExplanation>& explanation() const { return m_explanation; }
    /// From the choice, or the OTF's arrival, to the panel's being given the explanation, the last time; no value
    /// before the first.
    [[nodiscard]] std::optional<double> milliseconds() const { return m_milliseconds; }

signals:
    /// A person wants to see the document in which a second pane goes without the chosen tube core. It is one step.
    void comparisonRequested();
    /// explanation() is another.
    void explained();

private:
    struct Asked {
        std::shared_ptr<const ComputedOtf> otf;
        int number = 0;
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    void follow();
    void explain(const Asked& asked);
    void show(std::shared_ptr<const ShownExplanation> explanation);
    void tellWhatThePictureShows();
    void setMethod(const AdaptiveOtfConfig& config);
    void compare();

    Parts m_parts;
    bool m_seen = false;
    std::shared_ptr<const AdaptiveOtf> m_inPanel;  ///< whose tube cores the panel lists; holds no voxels
    std::optional<Asked> m_asked;                  ///< shown, or being explained; none while nobody sees the panel
    std::shared_ptr<const ShownExplanation> m_explanation;
    std::optional<double> m_milliseconds;
    TubeCorePictures m_pictures;
    NewestWinsThread m_thread;  ///< last, so that it has ended before anything above is destroyed
};

}  // namespace echolucent
