// Saves the explanation of a tube core as a page.
#pragma once

#include <QObject>
#include <functional>

#include "app/files/file_writing.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"

class QWidget;

namespace echolucent {

class MessageBar;
class PaneOtfs;
class Settings;
class StudyNames;
class TubeCoreExplaining;

/// The page is explanationPage() (app/pages/explanation_page.h) of what the panel *Tube cores* shows, with three
/// pictures of the scene. The scan is named as the window names it: by its name or by a number.
class TubeCorePage : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        const PaneOtfs& otfs;
        TubeCoreExplaining& explaining;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        std::function<QString(const QString& what)> proposedName;
    };
    /// What the parameters refer to must outlive this object.
    explicit TubeCorePage(const Parts& parts, QObject* parent = nullptr);

    /// Asks for a file and saves the page there.
    void choose();
    /// Does nothing if the panel shows no explanation or a page is being written. Refuses with a message while the
    /// document asks for a newer OTF than the one explained: the pictures would be of other curves than the plots.
    void save(const QString& path);

private:
    Parts m_parts;
    FileWriting m_writing;
};

}  // namespace echolucent
