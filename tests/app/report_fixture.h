// Case reports of the real main window: saving them, their pages and pictures, their dialog.
#pragma once

#include <QCheckBox>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMap>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>
#include <functional>

#include "tests/app/window_fixture.h"
#include "widgets/dialogs/report_dialog.h"
#include "widgets/planes/pane_grid.h"

namespace echolucent {

class ReportFixture : public WindowFixture {
public:
    [[nodiscard]] QString reportPath() const { return temporaryFolder().filePath("report.html"); }
    /// Saves a report and returns its page.
    QString saved(bool withAppendix = false) {
        window().saveReport(reportPath(), false, withAppendix);
        if (window().idle()) qFatal("nothing is being written");
        waitUntilIdle();
        return page();
    }
    [[nodiscard]] QString page() const {
        QFile file(reportPath());
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }
    /// The pictures of a page by their captions.
    static QMap<QString, QImage> picturesOf(const QString& page) {
        QMap<QString, QImage> pictures;
        static const QRegularExpression image("<img alt=\"([^\"]*)\"[^>]* src=\"data:image/png;base64,([^\"]*)\"/>");
        for (const auto& found : image.globalMatch(page))
            pictures[found.captured(1)] = QImage::fromData(QByteArray::fromBase64(found.captured(2).toLatin1()), "PNG");
        return pictures;
    }
    static QPlainTextEdit* textOf(ReportDialog* dialog, const char* name) {
        return dialog->findChild<QPlainTextEdit*>(QStringLiteral("report.") + name);
    }
    static QLineEdit* fieldOf(ReportDialog* dialog, const char* fact) {
        return dialog->findChild<QLineEdit*>(QStringLiteral("report.patient") + fact);
    }
    static void tickPatient(ReportDialog* dialog) {
        auto* patient = dialog->findChild<QCheckBox*>("report.patient");
        QTest::mouseClick(patient, Qt::LeftButton, {}, QPoint(10, patient->height() / 2));
    }
    ReportDialog* theDialog() {
        auto* dialog = window().findChild<ReportDialog*>("report");
        if (dialog == nullptr) qFatal("no dialog");
        return dialog;
    }
    /// Saves a report by the dialogs. `edit` answers the first one.
    void answerDialog(const std::function<void(ReportDialog*)>& edit) {
        QTimer::singleShot(0, &window(), [&] {
            auto* dialog = theDialog();
            edit(dialog);
            QTimer::singleShot(0, &window(), [&] {
                auto* files = window().findChild<QFileDialog*>("saveFile");
                if (files == nullptr) qFatal("no dialog of files");
                files->selectFile(reportPath());
                static_cast<QDialog*>(files)->done(QDialog::Accepted);
            });
            QTest::mouseClick(dialog->findChild<QPushButton*>("report.save"), Qt::LeftButton);
        });
        child<QAction>("file.saveReport")->trigger();
        waitUntilIdle();
    }
    void showPanes(PaneLayout layout) {
        child<PaneGrid>("panes")->setPaneLayout(layout);
        QTRY_VERIFY(window().idle());
        waitUntilIdle();
    }
};

}  // namespace echolucent
