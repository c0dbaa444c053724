#include "app/compare/compare_room.h"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <utility>

#include "app/compare/compare_page.h"
#include "app/compare/pane_parameters.h"
#include "app/compare/paper_figures.h"
#include "app/files/save_dialog.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/output/atomic_file.h"
#include "widgets/controls/message_bar.h"
#include "widgets/key_table.h"

namespace echolucent {

namespace {

constexpr const char *picturesTopic = "compared pictures", *measuresTopic = "compared measures",
                     *pageTopic = "comparison page";

QString topicOfOtf(std::size_t place) { return QStringLiteral("OTF of pane %1").arg(place + 1); }

}  // namespace

CompareRoom::CompareRoom(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_views({parts.model, parts.openStudy, parts.works, parts.otfs, parts.panes, parts.grid}),
      m_hand(parts.model, parts.openStudy, parts.grid),
      m_measures({parts.model, parts.openStudy, parts.works, parts.otfs, m_views, parts.player, parts.surfaces},
                 work()),
      m_pageWaits(parts.works, work()),
      m_figures({parts.window, parts.model, parts.openStudy, parts.works, parts.otfs, parts.panes, parts.player,
                 parts.editor, parts.messages},
                work()),
      m_writing(parts.works, "comparison page", work()) {
    connectPanel();
    // The 3D view tells of failures of the first pane and of the scene's adaptive OTF already.
    connect(&m_parts.otfs, &PaneOtfs::failed, this, [this](std::size_t place, const QString& sentence) {
        if (place != firstPane && place != PaneOtfs::adaptiveOfScene)
            m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::withStudy(topicOfOtf(place)));
    });
    connect(&m_parts.otfs, &PaneOtfs::computed, this,
            [this](std::size_t place) { m_parts.messages.takeBack(topicOfOtf(place)); });
    connect(&m_parts.model, &DocumentModel::changed, this, &CompareRoom::followPanes);
    connect(&m_hand, &CompareHand::cameraMoved, this, &CompareRoom::cameraMoved);
    // The page waits for works, and each of them tells Works when it ends.
    connect(&m_parts.works, &Works::changed, this, &CompareRoom::writeWaitingPage, Qt::QueuedConnection);
    connect(&m_views, &ComparedViews::failed, this, [this] {
        m_parts.player.pause();
        m_parts.messages.showMessage(MessageKind::error, tr("The pictures need more memory than this machine has."),
                                     MessageEnd::withStudy(picturesTopic));
        setWaitingPage({});
    });
    connect(&m_views, &ComparedViews::frameShown, this, [this] { m_parts.messages.takeBack(picturesTopic); });
    // A drag that ends where it began is no change of the document, and the panes are plain since it began.
    connect(&m_parts.grid, &CompareGrid::dragEnded, &m_measures, &CompareMeasures::follow);
    connect(&m_measures, &CompareMeasures::failed, this, [this](const QString& sentence) {
        m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::withStudy(measuresTopic));
    });
    connect(&m_measures, &CompareMeasures::rowsChanged, this, [this] { m_parts.messages.takeBack(measuresTopic); });
    connect(&m_parts.grid, &CompareGrid::focused, this, [this](std::size_t place) {
        if (std::exchange(m_explained, place) != place) emit explainedPaneChanged();
    });
    connect(&m_figures, &LessonFigures::setUp, this, [this] { setShown(m_hasPanes); });
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, [this] {
        setWaitingPage({});
        if (m_parts.openStudy.saved() && m_hasPanes) setShown(true);  // a session comes back as it was
    });
}

void CompareRoom::connectPanel() {
    DocumentModel& model = m_parts.model;
    ComparePanel& panel = m_parts.panel;
    connect(&panel, &ComparePanel::countChosen, this, [&model](int count) {
        model.edit(withPaneCount(model.document(), static_cast<std::size_t>(count)), tr("number of panes"));
    });
    connect(&panel, &ComparePanel::paneChosen, this, [&model](int place, const Pane& choice) {
        model.edit(withPane(model.document(), static_cast<std::size_t>(place), choice),
                   tr("OTF of pane %1").arg(place + 1));
    });
    connect(&panel, &ComparePanel::comparisonChosen, this, [&model](const Comparison& comparison, const QString& what) {
        model.change(what, [&comparison](Document& next) { next.comparison = comparison; });
    });
    connect(&panel, &ComparePanel::insetsSwitched, &m_views, &ComparedViews::setInsets);
    connect(&panel, &ComparePanel::flickerRequested, &m_measures, &CompareMeasures::measureFlicker);
    connect(&panel, &ComparePanel::pageRequested, this, &CompareRoom::chooseAndSavePage);
    connect(&m_measures, &CompareMeasures::measuringFlicker, &panel, &ComparePanel::setMeasuringFlicker);
    connect(&m_measures, &CompareMeasures::rowsChanged, &panel, &ComparePanel::setRows);
    connect(&model, &DocumentModel::changed, this, &CompareRoom::showInPanel);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &CompareRoom::showInPanel);
    showInPanel();
}

void CompareRoom::showInPanel() {
    const Document& document = m_parts.model.document();
    const Study* study = m_parts.openStudy.study();
    m_parts.panel.setLimits(study != nullptr ? static_cast<int>(study->phases.size()) : 1, configOf(document));
    m_parts.panel.setComparison(document.comparison);
    m_parts.panel.setPanes(isCompared(document) ? document.panes : std::vector<Pane>{}, captionsOfPanes(document));
}

/// Which room is shown follows the panes that somebody has chosen, not those that are only looked at.
void CompareRoom::followPanes() {
    const bool had = std::exchange(m_hasPanes, isCompared(m_parts.model.ownDocument()));
    if (m_hasPanes && !had) setShown(true);
    if (!isCompared(m_parts.model.document())) setShown(false);
}

Work CompareRoom::work() {
    return {.words = tr("comparing"), .urgency = Urgency::comparing, .cancel = [this] { cancel(); }};
}

void CompareRoom::setShown(bool shown) {
    if (shown == m_views.shown()) return;
    DocumentModel& model = m_parts.model;
    if (shown && !isCompared(model.document())) {
        const std::vector<Pane> panes = withPaneCount(model.document(), mostPanes).panes;
        model.lookAtPanes({panes.begin() + 1, panes.end()});
    }
    m_explained = firstPane;
    m_parts.rooms.setCurrentIndex(shown ? 1 : 0);
    m_views.setShown(shown);
    if (shown)
        m_parts.grid.pane(0).setFocus();
    else
        leave();
    if (!shown) model.endLookAtPanes();
    emit shownChanged(shown);
}

std::size_t CompareRoom::explainedPane() const {
    const Document& document = m_parts.model.document();
    const bool beside = shown() && document.comparison.layout == ComparisonLayout::sideBySide;
    return beside && m_explained < document.panes.size() ? m_explained : firstPane;
}

QImage CompareRoom::image() const { return m_views.settled() ? m_parts.grid.image() : QImage(); }

/// Cancelled measures begin again when the room is shown again.
void CompareRoom::leave() {
    cancel();
    m_measures.askAgain();
}

void CompareRoom::cancel() {
    m_measures.cancel();
    m_writing.cancel();
    m_figures.cancel();
    setWaitingPage({});
}

void CompareRoom::createMenu() {
    auto* menu = m_parts.window.findChild<QMenu*>(QStringLiteral("menu.room"));
    auto* compare = new QAction(tr("&Compare OTFs"), menu);
    compare->setObjectName(QStringLiteral("room.compare"));
    compare->setShortcut(keyOf(compare->objectName()));
    compare->setCheckable(true);
    connect(compare, &QAction::triggered, this, &CompareRoom::setShown);
    connect(this, &CompareRoom::shownChanged, compare, &QAction::setChecked);
    m_parts.panel.setSwitch(*compare);
    auto* figures = new QMenu(tr("Compare &for a lesson"), menu);
    figures->setObjectName(QStringLiteral("menu.compare"));
    figures->setToolTipsVisible(true);
    addFigures(*figures, {}, std::nullopt);
    figures->addSeparator();
    for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes}) {
        const bool fetus = scene == PhantomScene::fetus;
        const QString key = fetus ? QStringLiteral("fetus") : QStringLiteral("shapes");
        auto* onScan = figures->addMenu(fetus ? tr("On the simulated &fetus") : tr("On the simulated &shapes"));
        onScan->setObjectName(QStringLiteral("menu.compare.") + key);
        addFigures(*onScan, QLatin1Char('.') + key, SimulatedScan{.scene = scene});
    }
    figures->addSeparator();
    auto* motion = figures->addAction(tr("&Motion: one OTF, each view's, smoothed"));
    motion->setObjectName(QStringLiteral("compare.motions"));
    connect(motion, &QAction::triggered, this, [this] {
        m_parts.model.edit(motionSideBySide(m_parts.model.document()), tr("motion side by side"));
        setShown(true);
    });
    menu->addSeparator();
    menu->addAction(compare);
    menu->addMenu(figures);
    m_parts.window.addAction(compare);  // the key works also while the menu bar is hidden
    // Choosing a layout of the review room leaves the comparison.
    for (const char* layout : {"room.only3d", "room.quad", "room.large3d"})
        if (auto* action = m_parts.window.findChild<QAction*>(QLatin1String(layout)))
            connect(action, &QAction::triggered, this, [this] { setShown(false); });
}

void CompareRoom::addTo(EscapeOrder& escapes) {
    escapes.add(EscapeStep::drag, [this] { return m_parts.grid.cancelDrag(); });
    escapes.add(EscapeStep::maximisedPane, [this] { return shown() && m_parts.grid.endMaximised(); });
}

/// An entry for each figure, whose object name has this ending.
void CompareRoom::addFigures(QMenu& menu, const QString& ending, const std::optional<SimulatedScan>& scan) {
    for (const PaperFigure& figure : paperFigures()) {
        const QString number =
            figure.number < 10 ? QStringLiteral("&%1").arg(figure.number) : QString::number(figure.number);
        QAction* action = menu.addAction(tr("Figure %1: %2").arg(number, subjectOf(figure)));
        action->setObjectName(QStringLiteral("compare.figure%1%2").arg(figure.number).arg(ending));
        connect(action, &QAction::triggered, this,
                [this, number = figure.number, scan] { m_figures.show(number, scan); });
    }
}

void CompareRoom::chooseAndSavePage() {
    if (!shown()) return;
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save comparison"),
                                           .filter = tr("Pages (*.html)"),
                                           .name = m_parts.proposedName(QStringLiteral("comparison")),
                                           .suffix = QStringLiteral("html")});
    if (!path.isEmpty()) savePage(path);
}

void CompareRoom::savePage(const QString& path) {
    if (!shown() || m_writing.busy()) return;
    m_parts.player.pause();
    setWaitingPage(path);
    writeWaitingPage();
}

void CompareRoom::setWaitingPage(const QString& path) {
    m_waitingPage = path;
    m_pageWaits.set(!path.isEmpty());
}

void CompareRoom::giveUpPage(const QString& sentence) {
    setWaitingPage({});
    m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::withStudy(pageTopic));
}

void CompareRoom::writeWaitingPage() {
    if (m_waitingPage.isEmpty()) return;
    if (m_views.refused())
        return giveUpPage(tr("The page was not saved: the OTF of a pane was cancelled or could not be made."));
    if (!m_views.settled() || m_measures.busy() || m_parts.otfs.busy()) return;
    const QString path = m_waitingPage;
    const Document& document = m_parts.model.document();
    const auto& frame = m_views.frame();
    ComparePage page{.study = m_parts.openStudy.isSimulatedScan() ? tr("simulated scan")
                                                                  : m_parts.names.nameOf(m_parts.openStudy.path()),
                     .made = QDateTime::currentDateTime().toString(Qt::ISODate).replace('T', ' '),
                     .version = QApplication::applicationVersion(),
                     .seen = m_parts.explainView(),
                     .coloured = m_views.coloured(),
                     .panes = {}};
    const std::vector<CompareRow>& rows = m_measures.rows();
    for (std::size_t i = 0; i < frame->panes.size(); ++i) {
        const PaneRequest& shown = frame->request.panes[i];
        if (shown.pane >= document.panes.size() || shown.pane >= rows.size()) continue;
        ComparePage::Pane pane{shown.pane, rows[shown.pane], m_views.imageToSave(i),
                               m_views.paneAt(shown.pane).classification};
        pane.colour = colourOfPane(document.panes[shown.pane]);
        pane.parameters = parametersOfPane(document, shown.pane);
        pane.explanation = m_parts.explainOtf(shown.pane);
        page.panes.push_back(std::move(pane));
    }
    m_writing.begin(
        path,
        [page, file = path.toStdString()](const Progress&) { return writeFileAtomically(file, comparePageText(page)); },
        [this, path](const Result<void>& written) {
            if (written)
                m_parts.messages.showMessage(MessageKind::info,
                                             tr("The comparison was saved as %1.").arg(m_parts.names.nameOfOther(path)),
                                             MessageEnd::soon(pageTopic));
            else if (written.error().kind != FailureKind::cancelled)
                m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(written.error().sentence()),
                                             MessageEnd::withStudy(pageTopic));
        });
    setWaitingPage({});
}

}  // namespace echolucent
