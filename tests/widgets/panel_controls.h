// Finds a panel's controls by name, and counts its signals.
#pragma once

#include <QSignalSpy>
#include <QWidget>
#include <memory>
#include <vector>

namespace echolucent {

/// The control of the panel with this object name. If there is none, the test program ends.
template <typename Widget>
Widget* child(QWidget& panel, const char* name) {
    auto* found = panel.findChild<Widget*>(name);
    if (found == nullptr) qFatal("no %s", name);
    return found;
}

/// Counts emissions of every signal that this object itself declares.
class AllSignals {
public:
    explicit AllSignals(QObject& object) {
        const QMetaObject* type = object.metaObject();
        for (int i = type->methodOffset(); i < type->methodCount(); ++i) {
            if (type->method(i).methodType() != QMetaMethod::Signal) continue;
            m_spies.push_back(std::make_unique<QSignalSpy>(&object, type->method(i)));
        }
    }
    [[nodiscard]] qsizetype count() const {
        qsizetype sum = 0;
        for (const auto& spy : m_spies) sum += spy->count();
        return sum;
    }

private:
    std::vector<std::unique_ptr<QSignalSpy>> m_spies;
};

}  // namespace echolucent
