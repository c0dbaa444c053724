#include "app/lesson/lesson_handouts.h"

#include <QApplication>
#include <QWidget>
#include <string>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/lesson/shipped_lessons.h"
#include "app/pages/lesson_handout.h"
#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "app/study/study_names.h"
#include "io/output/atomic_file.h"
#include "processing/lesson/lesson_draft.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

namespace {

constexpr const char* handoutTopic = "handout of a lesson";

Result<void> writeHandout(const std::string& file, const Lesson& lesson, LessonHandout handout,
                          const Progress& progress) {
    auto pictures = lessonPictures(lesson, progress);
    if (!pictures) return fail(FailureKind::cancelled, file, {}, "was not written: cancelled");
    handout.pictures = std::move(*pictures);
    return writeFileAtomically(file, lessonHandout(lesson, handout));
}

}  // namespace

LessonHandouts::LessonHandouts(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_writing(parts.works, "lesson handout", {.words = tr("saving the handout"), .urgency = Urgency::saving}) {}

void LessonHandouts::choose(const Lesson& lesson, const std::string& language) {
    if (m_writing.busy()) {
        m_parts.messages.showMessage(MessageKind::info,
                                     tr("The handout before is still being saved. Try it again then."),
                                     MessageEnd::soon(handoutTopic));
        return;
    }
    const Lesson none;
    const std::string name = freeLessonId(none, textIn(lesson, language).title);
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save handout"),
                                           .filter = tr("Pages (*.html)"),
                                           .name = QString::fromStdString(name),
                                           .suffix = QStringLiteral("html")});
    if (!path.isEmpty()) save(lesson, language, path);
}

void LessonHandouts::save(const Lesson& lesson, const std::string& language, const QString& path) {
    if (m_writing.busy()) return;
    LessonHandout handout;
    handout.language = language;
    handout.program = tr("Echolucent %1").arg(QApplication::applicationVersion()).toStdString();
    m_writing.begin(
        path,
        [file = path.toStdString(), lesson, handout](const Progress& progress) {
            return writeHandout(file, lesson, handout, Progress{{}, progress.cancel});
        },
        [this, path](const Result<void>& written) {
            if (written)
                m_parts.messages.showMessage(MessageKind::info,
                                             tr("The handout was saved as %1.").arg(m_parts.names.nameOfOther(path)),
                                             MessageEnd::soon(handoutTopic));
            else if (written.error().kind != FailureKind::cancelled)
                m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(written.error().sentence()),
                                             MessageEnd::withStudy(handoutTopic));
        });
}

}  // namespace echolucent
