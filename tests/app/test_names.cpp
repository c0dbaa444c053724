// Every control has a name, keeps it, and docs/names.md holds it. The program writes that page, and the list of names
// of the present version, itself:
//   ECHOLUCENT_WRITE_PAGES=1 scripts/with-display build/release/bin/test_window TestNames
#include <QComboBox>
#include <QDir>
#include <QSpinBox>
#include <algorithm>
#include <set>
#include <utility>

#include "processing/picture/look.h"
#include "tests/app/used_controls.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/dialogs/movie_dialog.h"
#include "widgets/dialogs/picture_dialog.h"
#include "widgets/dialogs/raw_layout_dialog.h"
#include "widgets/dialogs/report_dialog.h"
#include "widgets/dialogs/series_dialog.h"
#include "widgets/names/names_page.h"

using namespace echolucent;

namespace {

const QString listOfNames = QStringLiteral(ECHOLUCENT_SOURCE_DIR "/tests/app/names/%1.txt");

QByteArray contentsOfFile(const QString& path) {
    QFile in(path);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

void writeIfAsked(const QString& path, const QByteArray& bytes) {
    if (!qEnvironmentVariableIsSet("ECHOLUCENT_WRITE_PAGES")) return;
    QFile out(path);
    QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
    QCOMPARE(out.write(bytes), bytes.size());
}

}  // namespace

class TestNames : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        teach();
        seeSides();
        show(lookAtStart());
        const auto still = smallPhantom(PhantomScene::fetus, 5);
        open(file("moving.mha", {still, still, still}));
        compareFourPanes();
        collect();
    }
    void cleanupTestCase() { close(); }

    void everyControlHasANameOfItsOwnAndALabel() {
        const QStringList problems = problemsOfNames(m_controls);
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join('\n')));
        QVERIFY2(m_controls.size() > 900, qPrintable(QString::number(m_controls.size())));
    }

    void whatHasNoNameIsFound() {
        QWidget part;
        auto* nameless = new QSpinBox(&part);
        nameless->setAccessibleName("Width");
        auto* silent = new QComboBox(&part);
        silent->setObjectName("silent");
        (new QSpinBox(&part))->setObjectName("silent");
        const QStringList problems = problemsOfNames(namedControls(part));
        QCOMPARE(problems.size(), 4);
        QVERIFY(problems[0].contains("“Width”") && problems[0].endsWith("has no object name"));
        QCOMPARE(problems[1], "silent (combo box) has no label");
        QCOMPARE(problems[2], "silent is the name of two");
        QCOMPARE(problems[3], "silent (number) has no label");
    }

    void noNameOfAnyVersionIsGone() {
        const QStringList now = sortedNames(m_controls);
        // A name is added when the list is written, and none is taken out.
        QStringList kept = QString::fromUtf8(contentsOfFile(listOfNames.arg(ECHOLUCENT_VERSION))).split('\n') + now;
        kept.removeAll(QString());
        std::sort(kept.begin(), kept.end());
        kept.removeDuplicates();
        writeIfAsked(listOfNames.arg(ECHOLUCENT_VERSION), kept.join('\n').toUtf8() + '\n');
        const QDir lists(QFileInfo(listOfNames).path());
        const QStringList versions = lists.entryList({"*.txt"});
        QVERIFY(versions.contains(ECHOLUCENT_VERSION ".txt"));
        const std::set<QString> known(now.begin(), now.end());
        for (const QString& version : versions) {
            QStringList gone =
                QString::fromUtf8(contentsOfFile(lists.filePath(version))).split('\n', Qt::SkipEmptyParts);
            QVERIFY2(gone.size() > 800, qPrintable(version));
            gone.removeIf([&](const QString& name) { return known.contains(name); });
            QVERIFY2(gone.isEmpty(), qPrintable(version + ", whose names must stay: " + gone.join(", ")));
        }
        const QString listed = QString::fromUtf8(contentsOfFile(listOfNames.arg(ECHOLUCENT_VERSION)));
        QVERIFY2(listed == now.join('\n') + '\n', "a new name is not in the list of this version: write it anew");
    }

    void thePageHoldsEveryNameAndWhatItSets() {
        const QByteArray expected = namesPage(m_controls, m_paths).toUtf8();
        const QString page = QStringLiteral(ECHOLUCENT_SOURCE_DIR "/docs/names.md");
        writeIfAsked(page, expected);
        const QList<QByteArray> are = contentsOfFile(page).split('\n'), should = expected.split('\n');
        for (qsizetype line = 0; line < std::max(are.size(), should.size()); ++line)
            QCOMPARE(are.value(line), should.value(line));
    }

    void aControlSetsWhatItsNameSays() {
        QCOMPARE(m_paths["view.brightness"], "`scene.look.brightness`");
        QCOMPARE(m_paths["view.colourMap"], "`scene.look.colour_map`");
        QCOMPARE(m_paths["room.quiet"], "`scene.planes.quiet`");
        QCOMPARE(m_paths["compare.otf2"], "`panes[1].curve`");
        QCOMPARE(m_paths["planes.a"], "`scene.planes.offset_mm`");
        QCOMPARE(m_paths["otfEditor.canvas"], "`curves.manual[0].opacity`, `panes[0].curve`");
        QVERIFY(m_paths["view3d"].contains("scene.pose"));
    }

private:
    void compareFourPanes() {
        QTest::keyClick(&window(), Qt::Key_F5);
        child<QSpinBox>("compare.count")->setValue(4);
        waitUntilIdle();
    }
    /// All controls of the window and its dialogs, and what those of the window set. Each designer has parameters of
    /// its own.
    void collect() {
        // Nobody looks at the window meanwhile: no picture is made of each change.
        window().hide();
        UsedControls used(window());
        take(namedControls(window()), &used);
        auto* designer = child<QComboBox>("designer.choice");
        for (int i = 1; i < designer->count(); ++i) {
            designer->setCurrentIndex(i);
            emit designer->activated(i);
            QCoreApplication::processEvents();
            take(namedControls(window()), &used);
        }
        for (const FrameOutput output : {FrameOutput::movie, FrameOutput::series})
            takeDialog(MovieDialog(output, {.held = {{1}, 0.05},
                                            .hindrance = [](const MovieChoice&) { return MovieHindrance{}; },
                                            .choosePath = {}}));
        takeDialog(PictureDialog({.of3d = {400, 300}, .ofPanes = {800, 600}}));
        takeDialog(ReportDialog({.filesNamePatient = true}));
        takeDialog(RawLayoutDialog("scan.raw", 1000));
        takeDialog(SeriesDialog("folder", {{"series 1", "66 slices"}}));
        waitUntilIdle();
    }
    template <typename Dialog>
    void takeDialog(Dialog&& dialog) {
        take(namedControls(dialog), nullptr);
    }
    void take(const std::vector<NamedControl>& controls, UsedControls* used) {
        const auto before = m_seen;
        for (NamedControl control : controls) {
            const bool isAction = control.role.startsWith("menu entry");
            if (!control.name.isEmpty() && before.contains({control.name, isAction})) continue;
            m_seen.emplace(control.name, isAction);
            m_controls.push_back(control);
            if (used == nullptr) continue;
            // A change makes some controls of a panel anew.
            if (!control.object) control.object = window().findChild<QWidget*>(control.name);
            QStringList paths = used->pathsSetBy(control);
            for (QString& path : paths) path = '`' + path + '`';
            if (!paths.isEmpty()) m_paths.try_emplace(control.name, paths.join(", "));
        }
    }

    std::vector<NamedControl> m_controls;
    std::set<std::pair<QString, bool>> m_seen;
    SetPaths m_paths;
};

ECHOLUCENT_TEST_CLASS(TestNames)

#include "test_names.moc"
