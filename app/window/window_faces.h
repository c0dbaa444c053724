// Review and Teach: which panels and which entries of the menus the window offers.
#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>
#include <vector>

#include "app/settings/settings.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace echolucent {

class MotionPanel;
class RunStatus;
class ViewPanel;

/// Puts on one of the two faces. Every control keeps its object name in both, and every key its meaning: what a face
/// does not offer is out of sight, and a key still opens it. What is open of the panels is remembered for each face
/// while the window lives.
class WindowFaces : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        Settings& settings;
        RunStatus& status;
        ViewPanel& picture;
        MotionPanel& motion;
    };
    /// The window has its docks and all menus.
    explicit WindowFaces(const Parts& parts, QObject* parent = nullptr);

    [[nodiscard]] Face face() const { return m_face; }
    void choose(Face face);
    /// Puts on the face of the last start. If the window's state was restored, its panels stay as they are.
    void restore(bool panelsAreRestored);

signals:
    void chosen(echolucent::Face face);

private:
    /// An entry of a menu that Teach offers alone. Its key works in both faces.
    struct Entry {
        QMenu* menu;
        QAction* action;
        QAction* before = nullptr;  ///< stands behind it
    };
    void createActions();
    void listEntries();
    void putOn(bool arrangesPanels);
    void arrangePanels();
    void offerEntries(bool offered);
    [[nodiscard]] bool isOffered(const QDockWidget& dock) const;
    [[nodiscard]] bool comparing() const;

    Parts m_parts;
    Face m_face = Face::review;
    std::vector<Entry> m_entries;
    bool m_entriesAreOffered = true;
    QMap<int, QStringList> m_open;  ///< names of the panels that were open, by face
};

}  // namespace echolucent
