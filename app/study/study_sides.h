// The six sides of the open study.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/study/open_study.h"
#include "processing/sides/side_search.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Whether the way of the beam may be told: the file or a person says it, or the scan is the simulated one.
[[nodiscard]] bool beamIsSure(const Beam& beam, const OpenStudy& openStudy);

/// Knows the sides of the first phase along the document's beam: those found on opening, else those that a thread
/// finds.
class StudySides : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    StudySides(const DocumentModel& model, const OpenStudy& openStudy, Works& works, QObject* parent = nullptr);

    /// Null until they are found.
    [[nodiscard]] const std::shared_ptr<const SidesFinding>& finding() const { return m_finding; }
    /// The phase that was searched; null if no study is open.
    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const { return m_volume; }

signals:
    /// Other sides are found, or none any more.
    void changed();

private:
    void follow();
    [[nodiscard]] std::shared_ptr<const SidesFinding> foundOnOpening() const;
    void set(std::shared_ptr<const SidesFinding> finding);

    const DocumentModel& m_model;
    const OpenStudy& m_openStudy;
    std::shared_ptr<const Volume> m_volume;
    std::optional<Beam> m_beam;  ///< of the finding, or of the one being made; no value if no study is open
    std::shared_ptr<const SidesFinding> m_finding;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
