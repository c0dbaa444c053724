// What the tests of the panels share: controls found by name, and the count of all that a panel says.
#pragma once

#include <QSignalSpy>
#include <QWidget>
#include <memory>
#include <vector>

namespace echolucent {

/// The control of the panel that bears this object name; the test program ends where there is none.
template <typename Widget>
Widget* child(QWidget& panel, const char* name) {
    auto* found = panel.findChild<Widget*>(name);
    if (found == nullptr) qFatal("no %s", name);
    return found;
}

/// How often any signal declared by this object itself was emitted.
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
