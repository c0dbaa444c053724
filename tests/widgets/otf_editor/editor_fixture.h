// The OTF editor on the screen, with a manual curve of three nodes.
#pragma once

#include <QAbstractButton>
#include <QTableView>
#include <QTest>
#include <memory>

#include "tests/widgets/otf_editor/edited_document.h"

namespace echolucent {

inline SampledCurve someAdaptiveCurve() { return {sampledOpacities(PowerCurve{3, 0.7}, 256)}; }

class EditorFixture {
public:
    void showEditor() {
        m_editor = std::make_unique<EditedEditor>();
        OtfEditorState state;
        state.manual = threeNodes;
        state.active = CurveKind::manual;
        m_editor->setState(state);
        m_editor->setValueWindow({0.0, 255.0});
        m_editor->resize(460, 640);
        m_editor->show();
        m_editor->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_editor.get()));
    }
    void close() { m_editor.reset(); }
    [[nodiscard]] EditedEditor& editor() { return *m_editor; }
    template <typename Widget>
    Widget* find(const QString& name) {
        auto* widget = m_editor->findChild<Widget*>(name);
        if (!widget) qFatal("no widget %s", qPrintable(name));
        return widget;
    }
    QTableView* table() { return find<QTableView>("otfEditor.nodeTable"); }
    [[nodiscard]] const ManualCurve& manual() { return m_editor->state().manual; }
    void click(const QString& name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }

private:
    std::unique_ptr<EditedEditor> m_editor;
};

}  // namespace echolucent
