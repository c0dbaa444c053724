#include "app/settings/settings_store.h"

#include <QSettings>
#include <utility>

namespace echolucent {

namespace {

QVariantMap valuesIn(const QSettings& settings) {
    QVariantMap values;
    for (const QString& key : settings.allKeys()) values.insert(key, settings.value(key));
    return values;
}

}  // namespace

SettingsStore::SettingsStore(const QString& file)
    : m_file(file), m_values(valuesIn(QSettings(file, QSettings::IniFormat))) {}

SettingsStore::~SettingsStore() { save(); }

QVariant SettingsStore::value(const QString& key, const QVariant& otherwise) const {
    return m_values.value(key, otherwise);
}

void SettingsStore::setValue(const QString& key, const QVariant& value) {
    if (const auto known = m_values.constFind(key); known != m_values.cend() && *known == value) return;
    change(key, value);
}

void SettingsStore::remove(const QString& key) {
    for (const QString& known : m_values.keys())
        if (known == key || known.startsWith(key + '/')) change(known, {});
}

void SettingsStore::change(const QString& key, const QVariant& value) {
    m_changes.insert(key, value);
    apply({{key, value}}, m_values);
    writeSoon();
}

void SettingsStore::apply(const Changes& changes, QVariantMap& values) {
    for (auto changed = changes.cbegin(); changed != changes.cend(); ++changed) {
        if (changed->isValid())
            values.insert(changed.key(), *changed);
        else
            values.remove(changed.key());
    }
}

SettingsStore::Written SettingsStore::write(const QString& file, const Changes& changes) {
    QSettings settings(file, QSettings::IniFormat);
    for (auto changed = changes.cbegin(); changed != changes.cend(); ++changed) {
        if (changed->isValid())
            settings.setValue(changed.key(), *changed);
        else
            settings.remove(changed.key());
    }
    settings.sync();
    return {settings.status() == QSettings::NoError, valuesIn(settings)};
}

void SettingsStore::writeSoon() {
    if (std::exchange(m_writesSoon, true)) return;
    QMetaObject::invokeMethod(this, &SettingsStore::writeNext, Qt::QueuedConnection);
}

void SettingsStore::writeNext() {
    m_writesSoon = false;
    if (m_changes.isEmpty() || (m_writing && m_writing->busy())) return;
    if (!m_writing) m_writing.emplace(m_works, QStringLiteral("settings"));
    m_beingWritten.insert(std::exchange(m_changes, {}));
    m_writing->submit([this, file = m_file, changes = m_beingWritten](const Progress&) -> NewestWinsThread::Deliver {
        return [this, written = write(file, changes)] { take(written); };
    });
}

void SettingsStore::take(const Written& written) {
    if (!written.whole) return;
    m_beingWritten.clear();
    m_values = written.values;
    apply(m_changes, m_values);
    if (!m_changes.isEmpty()) writeSoon();
}

bool SettingsStore::save() {
    m_writing.reset();  // changes whose writing was not reported yet are written once more
    m_beingWritten.insert(std::exchange(m_changes, {}));
    if (m_beingWritten.isEmpty()) return true;
    const Written written = write(m_file, m_beingWritten);
    take(written);
    return written.whole;
}

}  // namespace echolucent
