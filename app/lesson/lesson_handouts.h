// Saves lessons as pages for a class.
#pragma once

#include <QObject>
#include <QString>

#include "app/files/file_writing.h"
#include "processing/lesson/lesson.h"

class QWidget;

namespace echolucent {

class MessageBar;
class OpenStudy;
class Settings;
class StudyNames;
class Works;

/// A thread of its own simulates the lesson's scan and renders the pictures; the open study plays no part. The page is
/// lessonHandout() (app/pages/lesson_handout.h).
class LessonHandouts : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;
        OpenStudy& openStudy;
        Works& works;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
    };
    /// What the parts refer to must outlive this object.
    explicit LessonHandouts(const Parts& parts, QObject* parent = nullptr);

    /// Asks for a file and saves the page of a lesson, which must hold its rules, with the texts that textIn() gives.
    /// Says in a message if a page is just being saved.
    void choose(const Lesson& lesson, const std::string& language);
    /// Says in a message how that ended. Does nothing while a page is being saved.
    void save(const Lesson& lesson, const std::string& language, const QString& path);

private:
    Parts m_parts;
    FileWriting m_writing;
};

}  // namespace echolucent
