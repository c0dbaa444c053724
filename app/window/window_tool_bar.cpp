#include "app/window/window_tool_bar.h"

#include <QAction>
#include <QButtonGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <initializer_list>

#include "app/study/open_study.h"
#include "app/window/window_faces.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/tool_icons.h"
#include "widgets/document/document_model.h"

namespace echolucent {

namespace {

constexpr int pictureEdge = 24;  // logical pixels

QString barText(const char* text) { return QCoreApplication::translate("toolBar", text); }

/// What a button shows and is called.
struct ButtonWords {
    ToolPicture picture;
    const char* name;
    QString text;
    QString toolTip;
};

class ToolBar {
public:
    explicit ToolBar(const ToolBarParts& parts)
        : m_parts(parts), m_bar(new QToolBar(barText("Tool bar"), &parts.window)) {
        m_bar->setObjectName("toolBar");
        m_bar->setMovable(false);
        m_bar->setFloatable(false);
        m_bar->setIconSize({pictureEdge, pictureEdge});
        // Qt makes it for buttons that find no room.
        if (auto* more = m_bar->findChild<QToolButton*>("qt_toolbar_ext_button"))
            more->setAccessibleName(barText("More buttons"));
        m_bar->toggleViewAction()->setObjectName("toolBar.shown");
        m_bar->toggleViewAction()->setVisible(false);  // it always stays
        addButtons();
        addFaces();
        parts.window.addToolBar(m_bar);
    }

private:
    void addButtons() {
        addMenu(addButton({ToolPicture::open, "open", barText("Open"),
                           barText("Opens a volume (Ctrl+O); the arrow has more")}),
                {"file.open", "file.openFolder", "file.openRaw", "file.chooseSeries"}, "file.open")
            ->addActions({menuNamed("file.recent")->menuAction(), action("file.openSimulatedScan")});
        QToolButton* sides = needingStudy({ToolPicture::sides, "sides", barText("Sides"),
                                           barText("Looks into the scan from one of six sides (Ctrl+1 to Ctrl+6)")});
        QMenu* six = addMenu(sides, {"room.lookInFrom1", "room.lookInFrom2", "room.lookInFrom3", "room.lookInFrom4",
                                     "room.lookInFrom5", "room.lookInFrom6"});
        six->setObjectName("menu.sides");
        six->addSeparator();
        six->addAction(action("view.sides"));
        addMenu(needingStudy({ToolPicture::layout, "layout", barText("Layout"),
                              barText("The 3D picture alone, or with planes A, B and C (F2, F3, F4)")}),
                {"room.only3d", "room.quad", "room.large3d"});
        toggles(needingStudy({ToolPicture::box, "box", barText("Box"), barText("Box: shows only what lies in it (B)")}),
                "room.switchBox");
        addMenu(needingStudy({ToolPicture::front, "front", barText("Front"),
                              barText("Cuts away what lies before what you want to see")}),
                {"view.findFront", "view.frontFromHere", "view.noFront"});
        toggles(needingStudy({ToolPicture::scalpel, "scalpel", barText("Scalpel"),
                              barText("Cuts away what you draw around in the 3D picture (S)")}),
                "room.scalpel");
        addMeasure();
        addCurve();
        addMenu(
            needingStudy({ToolPicture::save, "save", barText("Save"),
                          barText("Saves the picture (P); the arrow has large pictures, movies, the session and the "
                                  "report")}),
            {"file.savePicture", "file.savePanes", "file.saveMovie", "file.savePictureSeries", "file.saveSession",
             "file.saveReport"},
            "file.savePicture");
        addMenu(needingStudy({ToolPicture::reset, "reset", barText("Reset"),
                              barText("Shows the whole scan upright again (R); the arrow has all else")}),
                {"view.resetView", "view.resetAll"}, "view.resetView");
        QAction* none = action("view.noFront");
        m_parts.document.bind(&DocumentModel::frontChanged, none, [none](const Document& document) {
            enableOrSayWhy(*none, cuts(document.scene.front), barText("There is no front to take away."));
        });
    }

    void addMeasure() {
        const QString distances = barText("Measures a distance (M) or an angle (Shift+M)");
        QToolButton* button = needingStudy({ToolPicture::measure, "measure", barText("Measure"), distances});
        QAction *distance = action("room.measureDistance"), *angle = action("room.measureAngle");
        addMenu(button, {"room.measureDistance", "room.measureAngle"}, "room.measureDistance");
        button->setCheckable(true);
        const auto show = [button, distance, angle] {
            button->setChecked(distance->isChecked() || angle->isChecked());
        };
        QObject::connect(
            &m_parts.openStudy, &OpenStudy::studyOpened, button, [button, distances, &openStudy = m_parts.openStudy] {
                const bool known = openStudy.volume()->geometry().spacingKnown;
                button->setToolTip(known ? distances
                                         : barText("%1. The file does not say how large a step is, so that "
                                                   "lengths are a guess")
                                               .arg(distances));
            });
        for (const QAction* tool : {distance, angle}) QObject::connect(tool, &QAction::toggled, button, show);
        QObject::connect(button, &QToolButton::clicked, button, show);
    }

    void addCurve() {
        QToolButton* button = addButton(
            {ToolPicture::curve, "curve", barText("Curve"),
             barText("Opens or closes the curve: it says which brightness is seen through and which is solid")});
        button->setCheckable(true);
        QDockWidget* dock = &m_parts.curve;
        QObject::connect(button, &QToolButton::clicked, dock, [button, dock] {
            const bool inFront = dock->isVisible() && !dock->visibleRegion().isEmpty();
            dock->setVisible(!inFront);
            if (!inFront) dock->raise();
            button->setChecked(!inFront);
        });
        QObject::connect(dock, &QDockWidget::visibilityChanged, button, &QToolButton::setChecked);
    }

    void addFaces() {
        auto* between = new QWidget;
        between->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        m_bar->addWidget(between);
        auto* group = new QButtonGroup(m_bar);
        const auto add = [&](Face face, const QString& text, const QString& name, const QString& toolTip) {
            auto* button = named(new QToolButton, name, text, toolTip);
            button->setText(text);
            button->setCheckable(true);
            button->setProperty("segment", true);
            button->setChecked(m_parts.faces.face() == face);
            group->addButton(button);
            m_bar->addWidget(button);
            QObject::connect(button, &QToolButton::clicked, &m_parts.faces,
                             [&faces = m_parts.faces, face] { faces.choose(face); });
            QObject::connect(&m_parts.faces, &WindowFaces::chosen, button,
                             [button, face](Face now) { button->setChecked(now == face); });
        };
        add(Face::review, barText("Review"), "face.review",
            barText("Shows what an examination needs: Picture, Measure and Study"));
        add(Face::teach, barText("Teach"), "face.teach",
            barText("Shows also the panels and menus that tell how the picture is made: curves, method, comparison"));
        auto* behind = new QWidget;
        behind->setFixedWidth(4);
        m_bar->addWidget(behind);
    }

    QToolButton* addButton(const ButtonWords& words) {
        auto* button =
            named(new QToolButton, QStringLiteral("toolBar.") + QLatin1String(words.name), words.text, words.toolTip);
        button->setText(words.text);
        button->setIcon(toolIcon(words.picture));
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        m_bar->addWidget(button);
        return button;
    }

    /// A button that is greyed until there is a study.
    QToolButton* needingStudy(const ButtonWords& words) {
        QToolButton* button = addButton(words);
        const auto follow = [button, &openStudy = m_parts.openStudy] {
            enableOrSayWhy(*button, openStudy.volume() != nullptr, barText("Open a volume first."));
        };
        QObject::connect(&m_parts.openStudy, &OpenStudy::volumeChanged, button, follow);
        QObject::connect(&m_parts.openStudy, &OpenStudy::studyOpened, button, follow);
        follow();
        return button;
    }

    /// Gives a button a menu of the window's own actions. A click triggers `first`; without it a click opens the menu.
    QMenu* addMenu(QToolButton* button, const std::initializer_list<const char*>& actions,
                   const char* first = nullptr) {
        auto* menu = new QMenu(button);
        menu->setObjectName(button->objectName() + QStringLiteral(".menu"));
        menu->setAccessibleName(button->accessibleName());
        menu->setToolTipsVisible(true);
        for (const char* name : actions) menu->addAction(action(name));
        button->setMenu(menu);
        button->setPopupMode(first != nullptr ? QToolButton::MenuButtonPopup : QToolButton::InstantPopup);
        if (first != nullptr) QObject::connect(button, &QToolButton::clicked, action(first), &QAction::trigger);
        return menu;
    }

    /// The button does what the action does, and is down while it is checked.
    void toggles(QToolButton* button, const char* name) {
        QAction* does = action(name);
        button->setCheckable(true);
        button->setChecked(does->isChecked());
        QObject::connect(button, &QToolButton::clicked, does, [button, does] {
            does->trigger();
            button->setChecked(does->isChecked());
        });
        QObject::connect(does, &QAction::toggled, button, &QToolButton::setChecked);
    }

    QAction* action(const char* name) const { return m_parts.window.findChild<QAction*>(QLatin1String(name)); }
    QMenu* menuNamed(const char* name) const { return m_parts.window.findChild<QMenu*>(QLatin1String(name)); }

    ToolBarParts m_parts;
    QToolBar* m_bar;
};

}  // namespace

void createToolBar(const ToolBarParts& parts) { ToolBar{parts}; }

}  // namespace echolucent
