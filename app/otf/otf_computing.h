// When the adaptive OTF is computed, for which view and with which parameters.
#pragma once

#include <QObject>
#include <optional>

#include "app/study/open_study.h"
#include "widgets/document/document_model.h"

namespace echolucent {

/// Asks the open study for the adaptive OTF whenever something it depends on changes in the document: the method, the
/// curve that is its initial function, the cut, the beam, and where one OTF serves all frames of a motion the phase
/// that it is of. The tubes begin where the picture begins.
class OtfComputing : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    OtfComputing(DocumentModel& model, OpenStudy& openStudy, QObject* parent = nullptr);

    /// From where the newest OTF that was asked for looks.
    [[nodiscard]] const Viewpoint& viewpoint() const { return m_asked; }
    /// Computes for a view; the document's direction stays, and is taken again when it changes.
    void computeFor(const Viewpoint& viewpoint);
    /// Computes for the newest view again, for example where something took the place of its computation.
    void computeAgain() { computeFor(m_asked); }
    /// Another study is open: the next OTF is that of the document's own direction.
    void begin();
    /// Makes the direction in which the view looks now that of the OTF, and the phase that it shows that of one OTF for
    /// all, as a step of the document ("compute for this view").
    void computeForThisView();

private:
    void follow();
    void sayPhase();

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Viewpoint m_asked;
    // What the document said when it was followed last.
    Viewpoint m_ofDocument;
    std::optional<int> m_phase;  ///< of the one OTF; none where each phase has its own
    AdaptiveOtfConfig m_config;
};

}  // namespace echolucent
