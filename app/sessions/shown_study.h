// Updates the window, except for the picture, when a study is opened, another phase is shown or an OTF is computed.
#pragma once

#include <QObject>

#include "app/motion/motion_frames.h"
#include "widgets/paced_words.h"

class QMainWindow;

namespace echolucent {

class CurveSliders;
class DesignerPanel;
class MessageBar;
class MethodPanel;
class OtfCoursePanel;
class OtfEditor;
class RunStatus;
class StudyNames;
class StudyPanel;
class ViewPanel;

/// Begins the document of a study, and gives facts and numbers to the editor and the panels.
class ShownStudy : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;  ///< its title
        DocumentModel& model;
        OpenStudy& openStudy;
        const PaneOtfs& otfs;
        const ShownPanes& panes;
        VolumeViewWidget& picture;
        MotionFrames& motion;
        MotionPlayer& player;
        OtfEditor& editor;
        MethodPanel& method;
        ViewPanel& controls;
        StudyPanel& facts;
        RunStatus& status;
        DesignerPanel& designers;
        CurveSliders& sliders;
        OtfCoursePanel& course;
        MessageBar& messages;
        StudyNames& names;
    };
    explicit ShownStudy(const Parts& parts, QObject* parent = nullptr);

    /// The document as it was when the study was opened, with what was found then.
    [[nodiscard]] const Document& opened() const { return m_opened; }
    /// The document with its steps, and opened(), to come back to them with the study.
    struct Kept {
        DocumentModel::Kept document;
        Document opened;
        int phases = 1;  ///< of the study
    };
    [[nodiscard]] Kept keep() const { return {m_parts.model.keep(), m_opened, m_phases}; }
    /// The next study that is replaced (OpenStudy::comeBack()) begins with what keep() gave.
    void bringBack(const Kept& kept) { m_broughtBack = kept; }
    /// The next study that is replaced takes over look, curves, method and panes of what keep() gave, and not those of
    /// the present document.
    void takeOverFrom(const Kept& kept) { m_takenOver = kept; }

signals:
    /// Another study's document takes the place of the present one.
    void aboutToBegin();

private:
    void tellFacts();
    void nameStudy();
    void showFacts();
    void entitle();
    [[nodiscard]] QStringList warnings() const;
    void takeVolume();
    void beginDocument();
    void takeOtf(std::size_t place);
    void showNumbers();
    void showRemark();
    [[nodiscard]] QStringList remarks() const;
    void showRemarkAtRest();
    void showFront();

    Parts m_parts;
    Document m_opened;
    std::optional<Kept> m_broughtBack, m_takenOver;
    bool m_asked = false;                             ///< a study is being loaded
    int m_phases = 1;                                 ///< of the study
    PacedWords m_numbers{[this] { showNumbers(); }};  ///< of the newest OTF
};

}  // namespace echolucent
